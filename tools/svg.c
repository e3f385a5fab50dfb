/* Pictures as SVG: the cells of a plane mesh, and the plot of a sweep. */
#include "command.h"
#include "file.h"
#include <math.h>
#include <string.h>

int is_svg(const char *path)
{
  size_t n = strlen(path);
  return n > 4 && strcmp(path + n - 4, ".svg") == 0;
}

/* ---- a mesh */

typedef struct frame {
  double low[2], scale, width, height;
} frame;

static frame frame_of(const gmds_soup *soup)
{
  double high[2] = {0, 0};
  frame f = {.low = {0, 0}};
  for (size_t v = 0; v < soup->n_points; v++)
    for (int k = 0; k < 2; k++) {
      double x = soup->points[v * (size_t)soup->dim + (size_t)k];
      f.low[k] = !v || x < f.low[k] ? x : f.low[k];
      high[k] = !v || x > high[k] ? x : high[k];
    }
  double extent = fmax(high[0] / 2 - f.low[0] / 2, high[1] / 2 - f.low[1] / 2); /* halves do not overflow */
  f.scale = extent > 0 ? 480 / extent : 0;
  f.width = (high[0] / 2 - f.low[0] / 2) * f.scale;
  f.height = (high[1] / 2 - f.low[1] / 2) * f.scale;
  return f;
}

static void print_point(FILE *file, const frame *f, const double *x)
{
  fprintf(file, "%.2f,%.2f", 20 + (x[0] / 2 - f->low[0] / 2) * f->scale,
          20 + f->height - (x[1] / 2 - f->low[1] / 2) * f->scale);
}

gmds_status write_picture(const char *path, const gmds_soup *soup, gmds_error *error)
{
  gmds_output output;
  GMDS_TRY(gmds_output_open(&output, path, error));
  FILE *file = output.file;
  const frame f = frame_of(soup);
  size_t d = (size_t)soup->dim;
  fprintf(file,
          "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.2f %.2f\">\n"
          "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n"
          "<g fill=\"#dce8f4\" stroke=\"#24507c\" stroke-width=\"%.3f\" stroke-linejoin=\"round\">\n",
          f.width + 40, f.height + 40, soup->n_cells > 20000 ? 0.1 : 0.6);
  for (size_t c = 0; c < soup->n_cells; c++) {
    int dim = gmds_cell_type_dimension((gmds_cell_type)soup->types[c]);
    if (dim != 1 && dim != 2)
      continue;
    fputs(dim == 2 ? "<polygon points=\"" : "<polyline points=\"", file);
    for (size_t k = soup->begin[c]; k < soup->begin[c + 1]; k++) {
      print_point(file, &f, soup->points + d * soup->corners[k]);
      fputc(' ', file);
    }
    fputs("\"/>\n", file);
  }
  fputs("</g>\n", file);
  for (size_t v = 0; v < soup->n_points && !soup->n_cells; v++) {
    fputs("<circle r=\"1\" fill=\"#24507c\" transform=\"translate(", file);
    print_point(file, &f, soup->points + d * v);
    fputs(")\"/>\n", file);
  }
  fputs("</svg>\n", file);
  return gmds_output_close(&output, GMDS_OK, error);
}

/* ---- a sweep: time against bytes, both logarithmic */

enum { LEFT = 90, TOP = 40, WIDTH = 640, HEIGHT = 420 };

typedef struct axes {
  double low[2], high[2]; /* powers of ten: bytes, seconds */
} axes;

static double value(const sweep_row *r, int axis)
{
  return log10(axis == 0 ? fmax((double)r->report.bytes, 1) : fmax(r->report.seconds, 1e-7));
}

static double across_axis(const axes *a, int axis, double x)
{
  double t = (x - a->low[axis]) / (a->high[axis] - a->low[axis]);
  return axis == 0 ? LEFT + WIDTH * t : TOP + HEIGHT * (1 - t);
}

static axes axes_of(const sweep_row *rows, size_t n)
{
  axes a = {{9, 3}, {0, -7}};
  for (size_t k = 0; k < n; k++)
    for (int axis = 0; axis < 2 && rows[k].ok; axis++) {
      a.low[axis] = fmin(a.low[axis], value(&rows[k], axis));
      a.high[axis] = fmax(a.high[axis], value(&rows[k], axis));
    }
  for (int axis = 0; axis < 2; axis++) {
    a.low[axis] = floor(5 * a.low[axis]) / 5;
    a.high[axis] = ceil(5 * a.high[axis] + 0.01) / 5;
  }
  return a;
}

static void print_ticks(FILE *file, const axes *a, int axis)
{
  static const double steps[] = {1, 2, 5};
  for (int power = (int)floor(a->low[axis]); power <= (int)ceil(a->high[axis]); power++)
    for (int s = 0; s < 3; s++) {
      double x = power + log10(steps[s]), at = across_axis(a, axis, x);
      if (x < a->low[axis] - 1e-9 || x > a->high[axis] + 1e-9)
        continue;
      double y = steps[s] * pow(10, power);
      if (axis == 0)
        fprintf(
            file,
            "<path stroke=\"#ddd\" d=\"M%.1f %d v%d\"/><text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%g kB</text>\n",
            at, TOP, HEIGHT, at, TOP + HEIGHT + 18, y / 1000);
      else
        fprintf(file,
                "<path stroke=\"#ddd\" d=\"M%d %.1f h%d\"/><text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%g s</text>\n",
                LEFT, at, WIDTH, LEFT - 6, at + 4, y);
    }
}

/* No other model is at once smaller and faster. */
static int on_front(const sweep_row *rows, size_t n, size_t k)
{
  for (size_t q = 0; q < n; q++)
    if (q != k && rows[q].ok && value(&rows[q], 0) <= value(&rows[k], 0) && value(&rows[q], 1) <= value(&rows[k], 1) &&
        (value(&rows[q], 0) < value(&rows[k], 0) || value(&rows[q], 1) < value(&rows[k], 1)))
      return 0;
  return 1;
}

static void print_dots(FILE *file, const axes *a, const sweep_row *rows, size_t n)
{
  for (int front = 0; front < 2; front++)
    for (size_t k = 0; k < n; k++) {
      if (!rows[k].ok || on_front(rows, n, k) != front)
        continue;
      double x = across_axis(a, 0, value(&rows[k], 0)), y = across_axis(a, 1, value(&rows[k], 1));
      fprintf(file,
              "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%s\" fill=\"%s\"><title>%s: %.6f s, %zu bytes</title></circle>\n", x,
              y, front ? "5" : "3.5", front ? "#c0392b" : "#24507c", rows[k].model, rows[k].report.seconds,
              rows[k].report.bytes);
      if (!front)
        continue;
      fprintf(file,
              "<text x=\"%.1f\" y=\"%.1f\" fill=\"#c0392b\" stroke=\"#fff\" stroke-width=\"3\" "
              "paint-order=\"stroke\">%s</text>\n",
              x + 9, y + 4, rows[k].model);
    }
}

gmds_status write_plot(const char *path, const sweep_row *rows, size_t n, gmds_error *error)
{
  gmds_output output;
  GMDS_TRY(gmds_output_open(&output, path, error));
  FILE *file = output.file;
  const axes a = axes_of(rows, n);
  fprintf(
      file,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n"
      "<text x=\"%d\" y=\"24\" font-size=\"15\">Delaunay triangulation of %zu points: one dot a mesh model, the Pareto "
      "front "
      "in red</text>\n",
      LEFT + WIDTH + 60, TOP + HEIGHT + 50, LEFT, n ? rows[0].points : 0);
  print_ticks(file, &a, 0);
  print_ticks(file, &a, 1);
  print_dots(file, &a, rows, n);
  fprintf(file, "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">bytes of the mesh</text>\n</svg>\n", LEFT + WIDTH / 2,
          TOP + HEIGHT + 40);
  return gmds_output_close(&output, GMDS_OK, error);
}
