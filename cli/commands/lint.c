/* What is wrong, or odd, with objects: for 'info'. */
#include "commands/facts.h"

#include <batten/model.h>
#include <math.h>
#include <string.h>

/* Knots nearer than this part of the domain are hard on other programmes. */
#define NEAR_KNOTS 1e-6

/* The shortest span as a part of the domain. */
static double shortest_span(int count, const double *knots)
{
    double shortest = knots[count - 1] - knots[0];
    for (int i = 1; i < count; i++)
        shortest = fmin(shortest, knots[i] - knots[i - 1]);
    return shortest / (knots[count - 1] - knots[0]);
}

static void note_knots(double share, const char *direction, const batten_object *object,
                       batten_notes *notes)
{
    if (share < NEAR_KNOTS)
        batten_notes_add(notes, "", 0, object->name,
                         "two knots%s are only %.3g of the domain apart", direction, share);
}

static batten_status lint_curve(const batten_object *object, batten_notes *notes)
{
    const int count = batten_curve_spans(object->curve, NULL);
    double *knots = batten_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(object->curve, knots);
    note_knots(shortest_span(count, knots), "", object, notes);
    batten_release(knots);
    return BATTEN_OK;
}

/* Is a border of the net one point? */
static bool is_pole(const batten_surface *surface, batten_direction fixed, bool high,
                    double tolerance)
{
    const int n = batten_surface_point_count(surface, BATTEN_U);
    const int m = batten_surface_point_count(surface, BATTEN_V);
    const int count = fixed == BATTEN_U ? m : n, dimension = batten_surface_dimension(surface);
    const double *points = batten_surface_points(surface), *first = NULL;
    for (int k = 0; k < count; k++) {
        const int i = fixed == BATTEN_U ? (high ? n - 1 : 0) : k;
        const int j = fixed == BATTEN_U ? k : (high ? m - 1 : 0);
        const double *p = &points[((size_t)i * (size_t)m + (size_t)j) * (size_t)dimension];
        first = first ? first : p;
        for (int c = 0; c < dimension; c++)
            if (fabs(p[c] - first[c]) > tolerance)
                return false;
    }
    return true;
}

static batten_status lint_surface(const batten_object *object, double tolerance,
                                  batten_notes *notes)
{
    static const char *const borders[2][2] = {{"u begins", "u ends"}, {"v begins", "v ends"}};
    const batten_surface *surface = object->surface;
    for (int d = 0; d < 2; d++) {
        const batten_direction direction = (batten_direction)d;
        const int count = batten_surface_spans(surface, direction, NULL);
        double *knots = batten_array((size_t)count, sizeof *knots);
        if (!knots)
            return BATTEN_OUT_OF_MEMORY;
        batten_surface_spans(surface, direction, knots);
        note_knots(shortest_span(count, knots), d ? " in v" : " in u", object, notes);
        batten_release(knots);
        for (int high = 0; high < 2 && strcmp(batten_surface_kind(surface), "nurbs") == 0;
             high++)
            if (is_pole(surface, direction, high, tolerance))
                batten_notes_remark(notes, "", 0, object->name,
                                    "a pole: its border where %s is one point",
                                    borders[d][high]);
    }
    return BATTEN_OK;
}

static void pass_note_on(const char *body, const batten_note *note, batten_notes *notes)
{
    if (note->is_remark)
        batten_notes_remark(notes, "", 0, body, "%s%s%s", note->entity,
                            *note->entity ? ": " : "", note->text);
    else
        batten_notes_add(notes, "", 0, body, "%s%s%s", note->entity, *note->entity ? ": " : "",
                         note->text);
}

/* The faults themselves are noted by the library, without the name of the body; here they are
 * told with it. */
static batten_status lint_body(const batten_object *object, batten_notes *notes)
{
    const batten_body_parts *parts = batten_body_view(object->body);
    batten_body_faults faults;
    batten_notes *own = NULL;
    batten_status status = batten_notes_create(100, &own);
    if (status == BATTEN_OK)
        status = batten_body_check(object->body, parts->tolerance, job_get(), own, &faults);
    for (int i = 0; status == BATTEN_OK && i < batten_notes_count(own); i++)
        pass_note_on(object->name, batten_notes_at(own, i), notes);
    if (status == BATTEN_OK && batten_notes_dropped(own) > 0)
        batten_notes_add(notes, "", 0, object->name, "and %d more", batten_notes_dropped(own));
    if (status == BATTEN_OK && faults.free_edges > 0 && parts->is_solid)
        batten_notes_add(notes, "", 0, object->name,
                         "it is marked as a solid, but has edges of one face: %d",
                         faults.free_edges);
    batten_notes_free(own);
    return status;
}

/* Why the mesh could not be checked, found by asking once more. */
static batten_status note_unchecked(const batten_object *object, batten_notes *notes)
{
    batten_mesh_facts f;
    const batten_status status = batten_mesh_check(object->mesh, &f);
    if (status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED)
        return status;
    batten_notes_add(notes, "", 0, object->name, "%s", batten_message());
    return BATTEN_OK;
}

static batten_status lint_mesh(const batten_object *object, const facts *told,
                               batten_notes *notes)
{
    if (!told->mesh_checked)
        return note_unchecked(object, notes);
    const batten_mesh_facts f = told->mesh;
    const struct {
        int count;
        const char *what;
    } faults[] = {{f.wrong_edges, "edges between triangles that are turned against each other"},
                  {f.crowded_edges, "edges of more than two triangles"},
                  {f.flat_triangles, "triangles without area"},
                  {f.loose_vertices, "vertices of no triangle"}};
    for (size_t k = 0; k < sizeof faults / sizeof faults[0]; k++)
        if (faults[k].count > 0)
            batten_notes_add(notes, "", 0, object->name, "%s: %d", faults[k].what,
                             faults[k].count);
    if (f.rim_edges > 0)
        batten_notes_remark(notes, "", 0, object->name, "edges of one triangle, its rim: %d",
                            f.rim_edges);
    return BATTEN_OK;
}

batten_status lint_object(const batten_object *object, const facts *f, batten_notes *notes)
{
    switch (object->kind) {
    case BATTEN_OBJECT_CURVE:
        return lint_curve(object, notes);
    case BATTEN_OBJECT_SURFACE:
        return lint_surface(object, f->tolerance, notes);
    case BATTEN_OBJECT_BODY:
        return lint_body(object, notes);
    case BATTEN_OBJECT_MESH:
        return lint_mesh(object, f, notes);
    default:
        return BATTEN_OK;
    }
}
