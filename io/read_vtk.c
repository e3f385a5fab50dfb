/* VTK legacy. */
#include "readers.h"

gmds_status gmds_read_vtk(gmds_text *text, gmds_stage *stage)
{
  (void)stage;
  return gmds_text_fail(text, GMDS_ERR_UNSUPPORTED, -1, "VTK is not read yet");
}
