/* The feature 'scattered-surface': a smooth surface through heights in no order. */
#include "base/plural.h"
#include "design/shared/rows.h"

#include <batten/scattered.h>

static const batten_parameter parameters[] = {
    {"scattered-surface", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "points in any order, or tables of offsets: heights z over x and y"},
    {"method", BATTEN_VALUE_WORD, false, false, "clough-tocher",
     "clough-tocher powell-sabin linear",
     "three cubics over each triangle, six quadratics, or planes"},
    {"gradients", BATTEN_VALUE_WORD, false, false, "local", "local network",
     "of quadratics near the neighbours, or of the network of edges that bends least"},
    {"triangles", BATTEN_VALUE_WORD, false, false, "delaunay", "delaunay data-dependent",
     "as round as possible, or along ridges and valleys"},
    {"same", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "points this near in x and y are one, with their mean height; only equal ones by default"},
    {"sliver", BATTEN_VALUE_NUMBER, false, false, "0.001", NULL,
     "triangles on the rim lower than this part of their side are left out"},
};

static void remark(bat_run *run, const batten_triangles_scattered_report *report)
{
    bat_report_error(run, report->error, report->rms);
    bat_remark(run, "%d triangle%s between %d vertices, in %d piece%s; distance at most %.3g",
               report->triangles, bat_plural(report->triangles), report->vertices,
               report->pieces, bat_plural(report->pieces), report->error);
    if (report->slivers > 0)
        bat_remark(run, "%d sliver%s on the rim %s left out", report->slivers,
                   bat_plural(report->slivers), bat_one_or_many(report->slivers, "is", "are"));
    if (report->swaps > 0)
        bat_remark(run, "%d edge%s %s swapped", report->swaps, bat_plural(report->swaps),
                   bat_one_or_many(report->swaps, "was", "were"));
    if (report->iterations > 0)
        bat_remark(run, "the network took %d step%s", report->iterations,
                   bat_plural(report->iterations));
    if (report->merged > 0 && !(report->conflict > 0))
        bat_remark(run, "%d point%s %s equal to others", report->merged,
                   bat_plural(report->merged), bat_one_or_many(report->merged, "is", "are"));
    if (report->conflict > 0)
        bat_note(run,
                 "%d point%s %s where others do, with heights up to %.3g apart (point %d): "
                 "their means are taken",
                 report->merged, bat_plural(report->merged),
                 bat_one_or_many(report->merged, "lies", "lie"), report->conflict,
                 report->conflicting + 1);
    if (report->planes > 0)
        bat_note(run, "near %d %s only planes are determined, no quadratics", report->planes,
                 bat_one_or_many(report->planes, "vertex", "vertices"));
    if (report->thinnest < 0.02)
        bat_note(run,
                 "there are thin pieces: an edge is cut at %.3g of its length; "
                 "'clough-tocher' has none",
                 report->thinnest);
}

static batten_status make_scattered_surface(const bat_run *run, int count, const double *points,
                                            batten_triangles_scattered_report *report,
                                            batten_triangles **out)
{
    batten_triangles_scattered_options options = batten_triangles_scattered_defaults();
    options.element = (batten_triangle_element)bat_word(run, "method");
    options.network = bat_word(run, "gradients") == 1;
    options.data_dependent = bat_word(run, "triangles") == 1;
    options.sliver = bat_number(run, "sliver");
    if (bat_has(run, "same"))
        options.tolerance = bat_number(run, "same");
    const size_t n = (size_t)count;
    double *xy = bat_array3(n, 2, sizeof *xy), *z = bat_array(n, sizeof *z);
    batten_triangles *function = NULL;
    batten_status status = xy && z ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < n; i++) {
        xy[2 * i] = points[3 * i];
        xy[2 * i + 1] = points[3 * i + 1];
        z[i] = points[3 * i + 2];
    }
    if (status == BATTEN_OK)
        status = batten_triangles_scattered((batten_points){2, count, xy}, z, &options,
                                            run->job, report, &function);
    if (status == BATTEN_OK)
        status = batten_triangles_from_function(function, out);
    batten_triangles_unref(function);
    bat_release(z);
    bat_release(xy);
    return status;
}

static batten_status run_scattered_surface(bat_run *run)
{
    int count = 0;
    double *points = NULL;
    batten_triangles_scattered_report report;
    batten_triangles *triangles = NULL;
    batten_status status = bat_gather_points(run, "scattered-surface", &count, &points);
    if (status == BATTEN_OK)
        status = make_scattered_surface(run, count, points, &report, &triangles);
    if (status == BATTEN_OK)
        remark(run, &report);
    bat_release(points);
    return bat_put_triangles(run, status, triangles);
}

const bat_feature bat_feature_scattered_surface = {
    .shown =
        {"scattered-surface", "A smooth surface through heights in no order",
         "Triangles between the points in the plane of x and y, and over them pieces that meet\n"
         "with one tangent plane: every point is met. The result is a set of Bezier triangles;\n"
         "'patches-of' makes surfaces of it. Points with the same x and y give their mean, and a\n"
         "note. For noisy heights use 'fit-scattered'.",
         "features:\n"
         "  spots: {points: [[0, 0, 1], [4, 0, 2], [0, 3, 1], [4, 3, 0], [2, 1, 2], [1, 2, 1], [3, 2, 1]]}\n"
         "  ground: {scattered-surface: spots, method: powell-sabin}\n",
         "[CT65], [PS77], [Nielson83], [DLR90]", "batten_triangles_scattered",
         BAT_PARAMETERS(parameters), false,
         .also =
             "Clough-Tocher, Powell-Sabin, Delaunay, triangulation, height field, minimum norm network",
         .formula =
             "    z(x_i, y_i) = z_i;  cubic (Clough-Tocher) or quadratic (Powell-Sabin) pieces over triangles,  ∇z continuous",
         .promise = "Every point is met and the tangent plane is continuous."},
    .run = run_scattered_surface};
