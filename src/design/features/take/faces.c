/* The feature 'faces': the surfaces of a body, whole. */
#include "design/feature.h"

#include <batten/nearest.h>
#include <stdio.h>

static const batten_parameter parameters[] = {
    {"faces", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "bodies; surfaces stay"},
};

/* Places of an edge at which it is compared with the border. */
enum { SAMPLES = 9 };

static batten_status sample_edge(const batten_curve *edge, double points[3 * SAMPLES])
{
    const batten_interval domain = batten_curve_domain(edge);
    batten_status status = BATTEN_OK;
    for (int i = 0; i < SAMPLES && status == BATTEN_OK; i++) {
        const double s = (double)i / (SAMPLES - 1);
        status = batten_curve_evaluate(edge, (1 - s) * domain.a + s * domain.b, 0,
                                       points + 3 * (size_t)i);
    }
    return status;
}

/* How far the edge is from the nearest of the border's curves, all along. */
static batten_status gap_to_border(const batten_curve *edge, const batten_body *border,
                                   double *gap)
{
    const batten_body_parts *parts = batten_body_view(border);
    double points[3 * SAMPLES], distances[SAMPLES], least[SAMPLES];
    batten_status status = sample_edge(edge, points);
    for (int i = 0; i < SAMPLES; i++)
        least[i] = HUGE_VAL;
    for (int k = 0; k < parts->edge_count && status == BATTEN_OK; k++) {
        batten_deviation deviation;
        if (!parts->edges[k].curve)
            continue;
        status = batten_curve_deviation(
            parts->edges[k].curve,
            (batten_points){batten_curve_dimension(parts->edges[k].curve), SAMPLES, points},
            NULL, NULL, distances, &deviation);
        for (int i = 0; i < SAMPLES && status == BATTEN_OK; i++)
            least[i] = bat_min(least[i], distances[i]);
    }
    *gap = 0;
    for (int i = 0; i < SAMPLES; i++)
        *gap = bat_max(*gap, least[i]);
    return status;
}

/* Does the face have loops elsewhere than along the border of its surface? */
static batten_status is_trimmed(const batten_body_parts *parts, const batten_body_face *face,
                                double tolerance, bool *out)
{
    batten_body *border = NULL;
    batten_status status = BATTEN_OK;
    *out = false;
    if (face->count)
        status = batten_body_from_surface("", face->surface, tolerance, &border);
    for (int l = 0; l < face->count && status == BATTEN_OK && !*out; l++) {
        const batten_body_loop *loop = &parts->loops[face->first + l];
        for (int k = 0; k < loop->count && status == BATTEN_OK && !*out; k++) {
            const batten_curve *edge = parts->edges[parts->uses[loop->first + k].edge].curve;
            double gap = 0;
            if (edge && batten_curve_dimension(edge) == 3)
                status = gap_to_border(edge, border, &gap);
            *out = gap > tolerance;
        }
    }
    batten_body_unref(border);
    return status;
}

/* The surface, with its normals outside. */
static batten_status add_face(bat_run *run, const batten_object *object,
                              const batten_body_face *face, int number)
{
    char name[260];
    batten_object named = *object;
    batten_surface *surface = NULL;
    batten_status status = BATTEN_OK;
    snprintf(name, sizeof name, "%.180s.%d%s%.60s", object->name, number,
             *face->name ? " " : "", face->name);
    named.name = name;
    named.body = NULL;
    if (face->has_colour) {
        named.has_colour = true;
        for (int k = 0; k < 3; k++)
            named.colour[k] = face->colour[k];
    }
    if (face->reversed)
        status = batten_surface_reverse(face->surface, BATTEN_U, &surface);
    else
        surface = batten_surface_ref(face->surface);
    return bat_put_surface_like(run, status, surface, &named);
}

static batten_status add_faces(bat_run *run, const batten_object *object)
{
    const batten_body_parts *parts = batten_body_view(object->body);
    const double tolerance = bat_max(parts->tolerance, bat_tolerance(run));
    batten_status status = BATTEN_OK;
    int trimmed = 0;
    for (int i = 0; i < parts->face_count && status == BATTEN_OK; i++) {
        const batten_body_face *face = &parts->faces[i];
        bool has_loops = false;
        status = is_trimmed(parts, face, tolerance, &has_loops);
        if (status == BATTEN_OK)
            status = add_face(run, object, face, i + 1);
        trimmed += has_loops;
    }
    if (status == BATTEN_OK && trimmed)
        bat_note(run,
                 "%d of %d faces of '%.60s' end elsewhere than their surfaces, which are "
                 "whole here",
                 trimmed, parts->face_count, object->name);
    return status;
}

static batten_status run_faces(bat_run *run)
{
    bat_objects shapes;
    batten_status status = bat_gather(run, "faces", BAT_BODIES | BAT_SURFACES, &shapes);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < shapes.count && status == BATTEN_OK; i++)
        status = shapes.at[i]->kind == BATTEN_OBJECT_BODY ? add_faces(run, shapes.at[i])
                                                          : bat_add(run, shapes.at[i]);
    bat_objects_release(&shapes);
    return status;
}

const bat_feature bat_feature_faces = {
    .shown =
        {"faces", "The surfaces of a body, whole",
         "One surface for each face, named by its number in the body and its own name: 'block.5\n"
         "top', with its normals outside. The surfaces of trimmed faces extend beyond their loops\n"
         "and fill their holes: a note says how many there are. 'mesh' respects the loops.",
         "features:\n"
         "  block: {read: block.step}\n"
         "  sides: {faces: block}\n",
         "[Part42]", "batten_body_view", BAT_PARAMETERS(parameters), false,
         .also = "extract faces, explode, untrim"},
    .run = run_faces,
    .displacing = "faces"};
