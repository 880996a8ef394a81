/* The feature 'unroll': a plate laid flat. */
#include "base/plural.h"
#include "design/feature.h"
#include "design/shared/outline.h"

#include <batten/interpolate.h>
#include <batten/nearest.h>
#include <batten/plate.h>
#include <batten/standard.h>

#include <stdio.h>

enum { MAX_RULINGS = 1000, FIRST_MARKS = 9, MAX_MARKS = 1025 };

static const batten_parameter parameters[] = {
    {"unroll", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the surface"},
    {"rulings", BATTEN_VALUE_WORD, false, false, "find", "find v u",
     "along which parameter the surface is straight; find: the straighter one"},
    {"lines", BATTEN_VALUE_COUNT, false, false, "12", NULL,
     "how many rulings are drawn, at equal steps of the parameter"},
    {"marks", BATTEN_VALUE_MODEL, true, false, NULL, NULL,
     "curves on the surface, laid flat with it on the layer 'marks'"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how accurate the outline is; the tolerance of the design by default"},
    {"strain", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "the largest strain the sheet may undergo; more is refused"},
};

static const double black[3] = {0, 0, 0}, grey[3] = {0.6, 0.6, 0.6}, blue[3] = {0, 0, 1};

/* ---- the outline ---- */

/* What is shorter than this is a point. */
static double no_length(const batten_unrolled *flat)
{
    return 1e-11 * (flat->length_first[1] + flat->length_second[1]);
}

/* Join the next piece to the outline, which may still be NULL; the piece is
 * given back. Where the vertex of a cone is left out, the pieces meet as well
 * as the edges are known. */
static batten_status add_piece(batten_status status, const batten_unrolled *flat,
                               batten_curve *piece, batten_curve **outline)
{
    return bat_outline_add(status, no_length(flat) + flat->error, piece, outline);
}

static double distance(const double *a, const double *b)
{
    return bat_hypot(a[0] - b[0], a[1] - b[1]);
}

/* A straight end of the sheet from one point to another; none where both edges
 * meet. */
static batten_status add_line(batten_status status, const batten_unrolled *flat,
                              const double *from, const double *to, batten_curve **outline)
{
    batten_curve *line = NULL;
    if (status != BATTEN_OK || distance(from, to) <= no_length(flat))
        return status;
    status = batten_curve_line(2, from, to, &line);
    return add_piece(status, flat, line, outline);
}

/* The parts of an edge that are not points: nothing is cut at the vertex of a cone.
 * NULL for none.
 */
static batten_status edge_pieces(const batten_unrolled *flat, int side, batten_curve **out)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i + 1 < flat->count && status == BATTEN_OK;) {
        const double *p = flat->points + 2 * side;
        int end = i;
        while (end + 1 < flat->count &&
               distance(p + 4 * end, p + 4 * end + 4) > no_length(flat))
            end++;
        if (end > i) {
            batten_curve *piece = NULL;
            status = batten_curve_subrange(side ? flat->second : flat->first, flat->u[i],
                                           flat->u[end], &piece);
            status = add_piece(status, flat, piece, out);
        }
        i = bat_max_int(end, i + 1);
    }
    return status;
}

static batten_status add_second_edge(const batten_unrolled *flat, batten_curve **outline)
{
    batten_curve *edge = NULL, *back = NULL;
    batten_status status = edge_pieces(flat, 1, &edge);
    if (status == BATTEN_OK && edge) {
        status = batten_curve_reverse(edge, &back);
        status = add_piece(status, flat, back, outline);
    }
    batten_curve_unref(edge);
    return status;
}

/* First edge, last ruling, second edge backwards, first ruling. */
static batten_status make_outline(const batten_unrolled *flat, batten_curve **outline)
{
    const double *start = flat->points, *end = flat->points + 4 * (flat->count - 1);
    batten_status status = edge_pieces(flat, 0, outline);
    status = add_line(status, flat, end, end + 2, outline);
    if (status == BATTEN_OK)
        status = add_second_edge(flat, outline);
    /* Back to where it began, so that it is closed even where a vertex was left
     * out. */
    double first[2];
    if (status == BATTEN_OK && *outline)
        status = batten_curve_evaluate(*outline, batten_curve_domain(*outline).a, 0, first);
    return *outline ? add_line(status, flat, start + 2, first, outline) : status;
}

static batten_status ruling_at(const batten_unrolled *flat, double u, batten_curve **line)
{
    double from[2], to[2];
    batten_status status = batten_curve_evaluate(flat->first, u, 0, from);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(flat->second, u, 0, to);
    if (status == BATTEN_OK)
        status = batten_curve_line(2, from, to, line);
    return status;
}

static batten_status put_lines(bat_run *run, const batten_unrolled *flat, int count)
{
    const double a = flat->u[0], b = flat->u[flat->count - 1];
    batten_status status = BATTEN_OK;
    for (int k = 1; k <= count && status == BATTEN_OK; k++) {
        const double u = a + (b - a) * k / (count + 1);
        batten_curve *line = NULL;
        status = ruling_at(flat, u, &line);
        status = bat_put_flat(run, status, line, "", "rulings", grey);
    }
    return status;
}

/* ---- marks ---- */

/* `count` points of a curve at equal steps, put on the surface and into the
 * plane. Room in `space` [count][3], `uv` [count][2], `plane` [count][2]. */
static batten_status lay_points(const batten_unrolled *flat, const batten_curve *curve,
                                double tolerance, int count, double *u, double *space,
                                double *uv, double *plane)
{
    const batten_interval domain = batten_curve_domain(curve);
    batten_deviation off;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        u[i] = i == count - 1 ? domain.b : domain.a + (domain.b - domain.a) * i / (count - 1);
        status = batten_curve_evaluate(curve, u[i], 0, space + 3 * i);
    }
    if (status == BATTEN_OK)
        status = batten_surface_project(flat->surface, (batten_points){3, count, space}, NULL,
                                        NULL, (batten_feet){uv, NULL}, &off);
    if (status == BATTEN_OK && off.max > tolerance)
        status = batten_fail(BATTEN_NOT_COMPATIBLE,
                             "a mark is %g from the surface at its parameter %g", off.max,
                             u[off.worst]);
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        batten_vec2 at = {0, 0};
        status = batten_unrolled_at(flat, uv[2 * i], uv[2 * i + 1], &at);
        plane[2 * i] = at.x;
        plane[2 * i + 1] = at.y;
    }
    return status;
}

/* The curve through every second of the points, and how far it is from the
 * others. */
static batten_status fit_mark(int count, const double *u, const double *plane, double *error,
                              batten_curve **out)
{
    const int n = (count + 1) / 2;
    double *every = batten_array((size_t)n * 3, sizeof *every), *at = every + 2 * n;
    if (!every)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n; i++) {
        every[2 * i] = plane[4 * i];
        every[2 * i + 1] = plane[4 * i + 1];
        at[i] = u[2 * i];
    }
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = at;
    batten_status status =
        batten_curve_interpolate((batten_points){2, n, every}, &options, NULL, out);
    *error = 0;
    for (int i = 1; i < count && status == BATTEN_OK; i += 2) {
        double q[2];
        status = batten_curve_evaluate(*out, u[i], 0, q);
        *error = bat_max(*error, distance(q, plane + 2 * i));
    }
    batten_release(every);
    return status;
}

static batten_status make_mark(const batten_unrolled *flat, const batten_curve *curve,
                               double tolerance, double *error, batten_curve **out)
{
    double *room = batten_array((size_t)MAX_MARKS * 8, sizeof *room);
    if (!room)
        return BATTEN_OUT_OF_MEMORY;
    double *u = room, *space = u + MAX_MARKS, *uv = space + 3 * MAX_MARKS;
    double *plane = uv + 2 * MAX_MARKS;
    batten_status status = BATTEN_OK;
    *error = HUGE_VAL;
    for (int count = FIRST_MARKS;
         count <= MAX_MARKS && status == BATTEN_OK && *error > tolerance;
         count = 2 * count - 1) {
        batten_curve_unref(*out);
        *out = NULL;
        status = lay_points(flat, curve, tolerance, count, u, space, uv, plane);
        if (status == BATTEN_OK)
            status = fit_mark(count, u, plane, error, out);
    }
    if (status == BATTEN_OK && *error > tolerance)
        status = batten_fail(BATTEN_TOLERANCE_NOT_MET, "a mark is within %g, not within %g",
                             *error, tolerance);
    batten_release(room);
    return status;
}

static batten_status mark_of(const batten_unrolled *flat, const batten_curve *curve,
                             double tolerance, double *error, batten_curve **mark)
{
    batten_curve *space = NULL;
    batten_status status = batten_curve_to_dimension(curve, 3, &space);
    if (status == BATTEN_OK)
        status = make_mark(flat, space, tolerance, error, mark);
    batten_curve_unref(space);
    return status;
}

static batten_status put_mark(bat_run *run, const batten_unrolled *flat, double tolerance,
                              const batten_object *object)
{
    batten_curve *mark = NULL;
    double error = 0;
    const batten_status status = mark_of(flat, object->curve, tolerance, &error, &mark);
    if (status == BATTEN_OK)
        bat_report_error(run, error, error);
    return bat_put_flat(run, status, mark, object->name, "marks", blue);
}

static batten_status put_marks(bat_run *run, const batten_unrolled *flat, double tolerance)
{
    bat_objects curves;
    batten_status status = bat_gather(run, "marks", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < curves.count && status == BATTEN_OK; i++)
        status = put_mark(run, flat, tolerance, curves.at[i]);
    bat_objects_release(&curves);
    return status;
}

static void report_unroll(bat_run *run, const batten_unrolled *flat)
{
    bat_remark(run,
               "edges %.8g and %.8g long, flat %.8g and %.8g; area %.8g, flat "
               "%.8g; turned by "
               "%.6g degree%s",
               flat->length_first[0], flat->length_second[0], flat->length_first[1],
               flat->length_second[1], flat->area[0], flat->area[1], flat->turn * 180 / BAT_PI,
               bat_plural_real(flat->turn * 180 / BAT_PI, 6));
    bat_remark(run,
               "strain at most %.2e at (%.6g, %.6g), rms %.2e; outline within "
               "%.1e, rulings "
               "straight within %.1e",
               flat->strain, flat->strain_at[0], flat->strain_at[1], flat->strain_rms,
               flat->error, flat->bow);
}

static batten_status put_sheet(bat_run *run, const batten_unrolled *flat, double tolerance)
{
    if (bat_has(run, "strain") && flat->strain > bat_number(run, "strain"))
        return batten_fail(
            BATTEN_NOT_COMPATIBLE,
            "laid flat the sheet undergoes a strain of %g at (%g, %g), more than "
            "%g",
            flat->strain, flat->strain_at[0], flat->strain_at[1], bat_number(run, "strain"));
    batten_curve *outline = NULL;
    batten_status status = make_outline(flat, &outline);
    if (status != BATTEN_OK) {
        batten_curve_unref(outline);
        return status;
    }
    report_unroll(run, flat);
    status = bat_put_flat(run, status, outline, run->name, "cut", black);
    if (status == BATTEN_OK)
        status = put_lines(run, flat, bat_count(run, "lines"));
    if (status == BATTEN_OK && bat_has(run, "marks"))
        status = put_marks(run, flat, tolerance);
    bat_report_error(run, flat->error, flat->error);
    return status;
}

static batten_status run_unroll(bat_run *run)
{
    static const batten_straight straight[] = {BATTEN_STRAIGHT_FIND, BATTEN_STRAIGHT_V,
                                               BATTEN_STRAIGHT_U};
    const int lines = bat_count(run, "lines");
    if (lines > MAX_RULINGS)
        return batten_fail(BATTEN_BAD_ARGUMENT, "%d lines; there may be 0 to %d", lines,
                           MAX_RULINGS);
    bat_objects surfaces;
    batten_status status = bat_gather(run, "unroll", BAT_SURFACES, &surfaces);
    if (status != BATTEN_OK)
        return status;
    batten_surface_unroll_options options = batten_surface_unroll_defaults();
    options.straight = straight[bat_word(run, "rulings")];
    options.tolerance = bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    batten_unrolled flat = {0};
    if (surfaces.count > 1)
        status = batten_fail(BATTEN_BAD_ARGUMENT, "one surface is unrolled at a time, not %d",
                             surfaces.count);
    else
        status = batten_surface_unroll(surfaces.at[0]->surface, &options, &flat);
    if (status == BATTEN_OK)
        status = put_sheet(run, &flat, options.tolerance);
    batten_unrolled_release(&flat);
    bat_objects_release(&surfaces);
    return status;
}

const bat_feature bat_feature_unroll = {
    .shown =
        {"unroll", "A plate laid flat",
         "The outline of a surface of straight lines, laid flat in the xy-plane, on the layer\n"
         "'cut', and some of its rulings on 'rulings', with 'marks' where they go. Developable\n"
         "surfaces, cones and cylinders keep every length; for others the distortion of the sheet\n"
         "is reported: lengths of edges, area and strain, in space and flat. Closed surfaces are\n"
         "cut at their seam. Write it as .dxf, or as 'sheet.svg: {write: sheet}', both at true\n"
         "scale.",
         "features:\n"
         "  funnel: {cone: 30 cm, top: 10 cm, height: 40 cm}\n"
         "  sheet: {unroll: funnel}\n"
         "outputs:\n"
         "  sheet.dxf: sheet\n",
         "[PW01]", "batten_surface_unroll", BAT_PARAMETERS(parameters), false,
         .also = "unfold, flatten, development, plate expansion, flat pattern, lay flat",
         .formula = "    triangles between rulings laid flat with their lengths in space",
         .promise = "Developable surfaces keep every length; else the distortion is reported."},
    .run = run_unroll,
    .displacing = "unroll"};
