/* The texts of statuses and errors. */
#include <gmds/status.h>
#include <stdarg.h>
#include <stdio.h>

const char *gmds_status_text(gmds_status status)
{
#define TEXT(name, text) text,
  static const char *const texts[] = {GMDS_STATUS_LIST(TEXT)};
#undef TEXT
  return (unsigned)status < GMDS_STATUS_COUNT ? texts[status] : "an unknown status";
}

gmds_status gmds_fail(gmds_error *error, gmds_status status, const char *format, ...)
{
  if (!error)
    return status;
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(error->text, sizeof error->text, format, arguments);
  va_end(arguments);
  error->status = status;
  error->line = 0;
  error->cell = -1;
  return status;
}
