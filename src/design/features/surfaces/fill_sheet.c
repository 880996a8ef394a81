/* The feature 'fill', where it is one trimmed surface. */
#include "base/plural.h"
#include "design/features/surfaces/fill.h"

#include <batten/body.h>
#include <string.h>

/* ---- what is inside ---- */

typedef struct {
    int point_count, curve_count;
    double *points;
    const batten_curve **curves;
    const char **names; /* of the points, then of the curves */
} inside;

static void release_inside(inside *in)
{
    bat_release(in->points);
    bat_release(in->curves);
    bat_release(in->names);
}

static int points_in(const bat_objects *objects)
{
    int count = 0;
    for (int i = 0; i < objects->count; i++)
        if (objects->at[i]->kind == BATTEN_OBJECT_POINTS)
            count += objects->at[i]->point_count;
    return count;
}

static batten_status collect(const bat_objects *objects, inside *in)
{
    const size_t points = (size_t)points_in(objects), curves = (size_t)objects->count;
    in->points = bat_array(points + 1, 3 * sizeof *in->points);
    in->curves = bat_array(curves + 1, sizeof(const batten_curve *));
    in->names = bat_array(points + curves + 1, sizeof(const char *));
    if (!in->points || !in->curves || !in->names)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < objects->count; i++) {
        const batten_object *o = objects->at[i];
        for (int k = 0; o->kind == BATTEN_OBJECT_POINTS && k < o->point_count; k++) {
            memcpy(in->points + 3 * (size_t)in->point_count, o->points + 3 * (size_t)k,
                   3 * sizeof *in->points);
            in->names[in->point_count++] = o->name;
        }
    }
    for (int i = 0; i < objects->count; i++)
        if (objects->at[i]->kind == BATTEN_OBJECT_CURVE) {
            in->names[in->point_count + in->curve_count] = objects->at[i]->name;
            in->curves[in->curve_count++] = objects->at[i]->curve;
        }
    return BATTEN_OK;
}

static batten_status take_inside(const bat_run *run, inside *in)
{
    bat_objects objects;
    if (!bat_has(run, "through"))
        return BATTEN_OK;
    batten_status status = bat_gather(run, "through", BAT_POINTS | BAT_CURVES, &objects);
    if (status != BATTEN_OK)
        return status;
    status = collect(&objects, in);
    bat_objects_release(&objects);
    return status;
}

/* ---- the body ---- */

/* All parts of a body with one face. */
typedef struct {
    double vertices[BATTEN_SHEET_SIDES][3];
    batten_body_edge edges[BATTEN_SHEET_SIDES];
    batten_body_use uses[BATTEN_SHEET_SIDES];
    batten_body_loop loop;
    batten_body_face face;
    batten_body_shell shell;
} body_parts;

static batten_status end_of(const batten_curve *curve, bool last, double out[3])
{
    const batten_interval domain = batten_curve_domain(curve);
    return batten_curve_evaluate(curve, last ? domain.b : domain.a, 0, out);
}

/* Vertex i: halfway between the end of side i - 1 and the start of side i. */
static batten_status find_vertices(const batten_fill_sheet *sheet, const batten_ribbon *sides,
                                   body_parts *parts)
{
    const int n = sheet->count;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < n; i++) {
        const batten_sheet_side *side = &sheet->sides[i],
                                *before = &sheet->sides[(i + n - 1) % n];
        double a[3], b[3];
        status = end_of(sides[before->curve].curve, !before->reversed, a);
        if (status == BATTEN_OK)
            status = end_of(sides[side->curve].curve, side->reversed, b);
        for (int c = 0; status == BATTEN_OK && c < 3; c++)
            parts->vertices[i][c] = a[c] / 2 + b[c] / 2;
    }
    return status;
}

static batten_status make_body(const batten_fill_sheet *sheet, const batten_ribbon *sides,
                               double tolerance, batten_body **out)
{
    body_parts *p = bat_array(1, sizeof *p);
    const int n = sheet->count;
    if (!p)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = find_vertices(sheet, sides, p);
    for (int i = 0; i < n; i++) {
        const batten_sheet_side *side = &sheet->sides[i];
        const int next = (i + 1) % n;
        p->edges[i] = (batten_body_edge){
            sides[side->curve].curve, {side->reversed ? next : i, side->reversed ? i : next}};
        p->uses[i] = (batten_body_use){i, side->reversed, side->parameters};
    }
    p->loop = (batten_body_loop){0, n};
    p->face = (batten_body_face){.name = "", .surface = sheet->surface, .count = 1};
    p->shell = (batten_body_shell){0, 1, false};
    const batten_body_parts parts = {.vertex_count = n,
                                     .vertices = p->vertices[0],
                                     .edge_count = n,
                                     .edges = p->edges,
                                     .use_count = n,
                                     .uses = p->uses,
                                     .loop_count = 1,
                                     .loops = &p->loop,
                                     .face_count = 1,
                                     .faces = &p->face,
                                     .shell_count = 1,
                                     .shells = &p->shell,
                                     .tolerance = tolerance,
                                     .is_traced = true};
    if (status == BATTEN_OK)
        status = batten_body_create(&parts, out);
    bat_release(p);
    return status;
}

/* ---- what was reached ---- */

static void report_sheet(const bat_run *run, const bat_objects *curves, const inside *in,
                         const batten_fill_sheet_report *reached)
{
    const char *unit = batten_unit_name(bat_unit_metres(run));
    const bat_worst_edges none = {NULL, NULL, NULL};
    const bat_worst_edges worst = bat_find_worst_edges(reached->count, reached->outer, none);
    bat_remark(run,
               "one surface of %d x %d spans, trimmed by %d side%s; inside it four "
               "derivatives are continuous",
               reached->columns, reached->rows, reached->count, bat_plural(reached->count));
    bat_remark_worst_edges(run, curves, unit ? unit : "unit", &worst);
    if (reached->inside != 0) {
        const int k =
            reached->inside > 0 ? reached->inside - 1 : in->point_count - 1 - reached->inside;
        bat_remark(run, "what is inside is missed by up to %.2g %s ('%.100s', at %g, %g, %g)",
                   reached->inside_gap, unit ? unit : "unit", in->names[k],
                   reached->inside_at[0], reached->inside_at[1], reached->inside_at[2]);
    }
}

/* How far the sheet is from all that was given. */
static double missed(const batten_fill_sheet_report *reached)
{
    double gap = reached->inside_gap;
    for (int i = 0; i < reached->count; i++)
        gap = bat_max(gap, reached->outer[i].gap);
    return gap + reached->loop_gap / 2; /* corners meet halfway */
}

static batten_status put_sheet(bat_run *run, const batten_fill_sheet *sheet,
                               const bat_hole *hole)
{
    batten_body *body = NULL;
    batten_status status = make_body(sheet, hole->ribbons, hole->within, &body);
    if (status == BATTEN_OK) {
        const batten_object object = {
            .name = run->name, .layer = "", .kind = BATTEN_OBJECT_BODY, .body = body};
        status = bat_add(run, &object);
    }
    batten_body_unref(body);
    return status;
}

static batten_status fill_sheet(bat_run *run, const bat_objects *curves, const bat_hole *hole,
                                const inside *in, batten_fill_sheet_report *reached)
{
    batten_fill_sheet_options options = batten_fill_sheet_defaults();
    batten_fill_sheet *sheet = bat_array(1, sizeof *sheet);
    if (!sheet)
        return BATTEN_OUT_OF_MEMORY;
    options.tolerance = hole->within;
    options.angle = bat_number(run, "angle");
    options.curvature = bat_word(run, "continuity") == 2;
    if (bat_has(run, "curvature"))
        options.most_curvature = bat_number(run, "curvature");
    options.points = (batten_points){3, in->point_count, in->points};
    options.curves = (batten_curve_row){in->curve_count, in->curves};
    batten_status status =
        batten_surface_fill_sheet(hole->count, hole->ribbons, &options, reached, sheet);
    if (status == BATTEN_OK) {
        report_sheet(run, curves, in, reached);
        bat_report_error(run, missed(reached), missed(reached));
        status = put_sheet(run, sheet, hole);
        batten_fill_sheet_release(sheet);
    }
    bat_release(sheet);
    return status;
}

batten_status bat_fill_by_sheet(bat_run *run, const bat_objects *curves, const bat_hole *hole)
{
    inside in = {0, 0, NULL, NULL, NULL};
    batten_fill_sheet_report *reached = bat_array(1, sizeof *reached);
    batten_status status = reached ? take_inside(run, &in) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = fill_sheet(run, curves, hole, &in, reached);
    release_inside(&in);
    bat_release(reached);
    return status;
}
