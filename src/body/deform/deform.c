/* Bodies under a deformation: surfaces as far as their faces reach, edges and vertices, put together as they were. */
#include "base/plural.h"
#include "body/builder.h"
#include "numeric/box.h"
#include "shape/deform/lattice.h"

#include <string.h>

typedef struct {
    const batten_body_parts *parts;
    const batten_deformation *deformation;
    double tolerance, error;
    bat_builder builder;
} deforming;

static batten_status deform_edges(deforming *t)
{
    batten_status status = BATTEN_OK;
    int index;
    for (int i = 0; status == BATTEN_OK && i < t->parts->vertex_count; i++) {
        const double *at = &t->parts->vertices[3 * (size_t)i];
        double moved[3];
        status = bat_deformation_check(t->deformation, bat_box_at(at), "a vertex");
        if (status != BATTEN_OK)
            break;
        bat_deformation_point(t->deformation, at, moved);
        status = bat_builder_vertex(&t->builder, moved, &index);
    }
    for (int i = 0; status == BATTEN_OK && i < t->parts->edge_count; i++) {
        const batten_body_edge *edge = &t->parts->edges[i];
        batten_curve *curve = NULL;
        double error = 0;
        if (edge->curve)
            status =
                batten_curve_deform(edge->curve, t->deformation, t->tolerance, &error, &curve);
        t->error = bat_max(t->error, error);
        if (status == BATTEN_OK)
            status = bat_builder_edge(&t->builder, curve, edge->vertices[0], edge->vertices[1],
                                      &index);
        batten_curve_unref(curve);
    }
    return status;
}

/* The parameters that the loops of a face reach: its curves lie within the boxes of their control points. */
static batten_box reach_of_face(const batten_body_parts *parts, const batten_body_face *face)
{
    batten_box box = bat_box_of_nothing();
    for (int l = 0; l < face->count; l++) {
        const batten_body_loop *loop = &parts->loops[face->first + l];
        for (int k = 0; k < loop->count; k++) {
            const batten_curve *curve = parts->uses[loop->first + k].parameters;
            if (curve)
                bat_box_join(&box, batten_curve_box(curve));
        }
    }
    return box;
}

static batten_status cut_surface(batten_direction direction, double a, double b,
                                 batten_surface **surface)
{
    const batten_interval all = batten_surface_domain(*surface, direction);
    const batten_interval part = {bat_max(a, all.a), bat_min(b, all.b)};
    batten_surface *cut = NULL;
    if (!(part.a < part.b) || (part.a == all.a && part.b == all.b) ||
        batten_surface_is_periodic(*surface, direction))
        return BATTEN_OK;
    const batten_status status =
        batten_surface_subrange(*surface, direction, part.a, part.b, &cut);
    if (status == BATTEN_OK) {
        batten_surface_unref(*surface);
        *surface = cut;
    }
    return status;
}

static batten_status deform_surface(deforming *t, const batten_body_face *face,
                                    batten_surface **out)
{
    const batten_box reach = reach_of_face(t->parts, face);
    batten_surface *part = batten_surface_ref(face->surface);
    batten_status status = BATTEN_OK;
    double error = 0;
    if (!bat_box_is_of_nothing(reach)) {
        status = cut_surface(BATTEN_U, reach.low.x, reach.high.x, &part);
        if (status == BATTEN_OK)
            status = cut_surface(BATTEN_V, reach.low.y, reach.high.y, &part);
    }
    if (status == BATTEN_OK)
        status = batten_surface_deform(part, t->deformation, t->tolerance, &error, out);
    t->error = bat_max(t->error, error);
    batten_surface_unref(part);
    return status;
}

static batten_status deform_face(deforming *t, const batten_body_face *face)
{
    batten_surface *surface = NULL;
    batten_body_face made = *face;
    batten_status status = deform_surface(t, face, &surface);
    made.surface = surface;
    if (status == BATTEN_OK)
        status = bat_builder_face(&t->builder, &made);
    for (int l = 0; status == BATTEN_OK && l < face->count; l++) {
        const batten_body_loop *loop = &t->parts->loops[face->first + l];
        status = bat_builder_loop(&t->builder);
        for (int k = 0; status == BATTEN_OK && k < loop->count; k++) {
            const batten_body_use *use = &t->parts->uses[loop->first + k];
            status = bat_builder_use(&t->builder, use->edge, use->reversed, use->parameters);
        }
    }
    batten_surface_unref(surface);
    return status;
}

static batten_status deform_parts(deforming *t, batten_body **out)
{
    const batten_body_parts *parts = t->parts;
    const double stretched = parts->tolerance * bat_deformation_stretch(t->deformation);
    bat_builder_begin(&t->builder, stretched + 2 * t->tolerance);
    batten_status status = deform_edges(t);
    for (int i = 0; status == BATTEN_OK && i < parts->shell_count; i++) {
        const batten_body_shell *shell = &parts->shells[i];
        status = bat_builder_shell(&t->builder, shell->closed);
        for (int k = 0; status == BATTEN_OK && k < shell->count; k++)
            status = deform_face(t, &parts->faces[shell->first + k]);
    }
    t->builder.parts.is_traced = parts->is_traced;
    if (status == BATTEN_OK)
        return bat_builder_finish(&t->builder, parts->is_solid, out);
    bat_builder_end(&t->builder);
    return status;
}

/* The body with parameter curves for every use. */
static batten_status trace_body(const batten_body *body, const batten_job *job,
                                batten_body **out)
{
    batten_body_trace_report report;
    if (batten_body_view(body)->is_traced) {
        *out = batten_body_ref(body);
        return BATTEN_OK;
    }
    batten_status status =
        batten_body_trace(body, batten_body_view(body)->tolerance, job, NULL, &report, out);
    if (status == BATTEN_OK && report.failed > 0) {
        batten_body_unref(*out);
        status = bat_fail(BATTEN_NOT_COMPATIBLE,
                          "%d face%s of the body cannot be traced, because their edges do not "
                          "lie on them or do not close",
                          report.failed, bat_plural(report.failed));
    }
    return status;
}

batten_status batten_body_deform(const batten_body *body, const batten_deformation *deformation,
                                 double tolerance, const batten_job *job, double *error,
                                 batten_body **out)
{
    assert(body && deformation && out);
    batten_body *traced = NULL;
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", tolerance);
    batten_status status = trace_body(body, job, &traced);
    if (status != BATTEN_OK)
        return status;
    deforming t = {
        .parts = batten_body_view(traced), .deformation = deformation, .tolerance = tolerance};
    status = deform_parts(&t, out);
    if (status == BATTEN_OK && error)
        *error = t.error;
    batten_body_unref(traced);
    return status;
}
