/* The feature 'deform': free-form deformation by a box of lattice points. */
#include "base/plural.h"
#include "design/feature.h"
#include "numeric/box.h"

#include <batten/measure.h>
#include <batten/offset.h>
#include <string.h>

#define KINDS (BAT_POINTS | BAT_CURVES | BAT_SURFACES | BAT_BODIES | BAT_MESHES)

static const batten_parameter parameters[] = {
    {"deform", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the points, curves, surfaces, bodies and meshes"},
    {"move", BATTEN_VALUE_MOVE, true, false, NULL, NULL,
     "lattice points, counted from 1 in x, y and z, and how far each moves"},
    {"lattice", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "instead: where all lattice points are, 1 1 1, 1 1 2 ... first"},
    {"counts", BATTEN_VALUE_COUNT, true, false, "4", NULL,
     "lattice points in x, y and z, or one number for all"},
    {"degree", BATTEN_VALUE_COUNT, true, false, "3", NULL,
     "in x, y and z, or one for all; less where there are few points"},
    {"box", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "two opposite corners; those of the shapes by default"},
    {"outside", BATTEN_VALUE_WORD, false, false, "refuse", "refuse position tangent curvature",
     "what leaves the box: it stays, and joins with this continuity"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far from the exact image; the tolerance of the design by default"},
};

/* ---- the box ---- */

static batten_status find_extent(const bat_run *run, const batten_object *object,
                                 batten_box *box)
{
    batten_status status = BATTEN_OK;
    batten_body_measures measures;
    switch (object->kind) {
    case BATTEN_OBJECT_CURVE:
        return batten_curve_bounds(object->curve, box);
    case BATTEN_OBJECT_SURFACE:
        return batten_surface_bounds(object->surface, bat_tolerance(run) / 10, NULL, box);
    case BATTEN_OBJECT_BODY:
        status = batten_body_measure(object->body, bat_tolerance(run), run->job, &measures);
        *box = measures.box;
        return status;
    case BATTEN_OBJECT_MESH:
        *box = batten_mesh_box(object->mesh);
        return BATTEN_OK;
    default:
        *box = bat_box_of_nothing();
        for (int i = 0; i < object->point_count; i++)
            bat_box_join(box, bat_box_at(object->points + 3 * i));
        return BATTEN_OK;
    }
}

/* Where shapes are flat the box gets half of its largest extent to both sides. */
static void thicken_box(const bat_run *run, batten_box *box)
{
    double *low[3] = {&box->low.x, &box->low.y, &box->low.z},
           *high[3] = {&box->high.x, &box->high.y, &box->high.z}, largest = 0;
    for (int k = 0; k < 3; k++)
        largest = bat_max(largest, *high[k] - *low[k]);
    for (int k = 0; k < 3; k++) {
        if (*high[k] - *low[k] > bat_tolerance(run))
            continue;
        *low[k] -= largest / 2;
        *high[k] += largest / 2;
        bat_remark(run, "the shapes are flat in %c; the box runs from %.4g to %.4g there",
                   'x' + k, *low[k], *high[k]);
    }
}

static batten_status find_box(const bat_run *run, const bat_objects *objects, batten_box *out)
{
    const bat_argument *given = bat_argument_of(run, "box");
    batten_status status = BATTEN_OK;
    *out = bat_box_of_nothing();
    if (given->count != 0 && given->count != 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'box' has %d corner%s, not 2", given->count,
                        bat_plural(given->count));
    for (int i = 0; i < given->count; i++)
        bat_box_join(out, bat_box_at(given->items[i].number));
    if (given->count == 2)
        return BATTEN_OK;
    for (int i = 0; i < objects->count && status == BATTEN_OK; i++) {
        batten_box box;
        status = find_extent(run, objects->at[i], &box);
        if (status == BATTEN_OK)
            bat_box_join(out, box);
    }
    if (status == BATTEN_OK)
        thicken_box(run, out);
    return status;
}

/* ---- the lattice ---- */

static batten_status find_three(const bat_run *run, const char *parameter, int out[3])
{
    const bat_argument *given = bat_argument_of(run, parameter);
    if (given->count != 1 && given->count != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' has 1 or 3 numbers, not %d", parameter,
                        given->count);
    for (int k = 0; k < 3; k++)
        out[k] = given->items[given->count == 3 ? k : 0].count;
    return BATTEN_OK;
}

static batten_status find_lattice(const bat_run *run, const bat_objects *objects,
                                  batten_lattice *out)
{
    batten_status status = find_three(run, "counts", out->counts);
    if (status == BATTEN_OK)
        status = find_three(run, "degree", out->degrees);
    for (int k = 0; k < 3 && status == BATTEN_OK; k++)
        if (!bat_argument_of(run, "degree")->given && out->degrees[k] >= out->counts[k])
            out->degrees[k] = out->counts[k] - 1;
    return status == BATTEN_OK ? find_box(run, objects, &out->box) : status;
}

/* Add one move to the lattice. */
static batten_status move_point(const batten_lattice *l, const double row[6], int index,
                                double *points)
{
    int at[3];
    for (int k = 0; k < 3; k++) {
        if (!(row[k] >= 1 && row[k] <= l->counts[k] && row[k] == floor(row[k])))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "move %d is of lattice point (%.6g, %.6g, %.6g); in %c they are "
                            "counted 1 to %d",
                            index + 1, row[0], row[1], row[2], 'x' + k, l->counts[k]);
        at[k] = (int)row[k] - 1;
    }
    double *point = points + 3 * ((at[0] * l->counts[1] + at[1]) * l->counts[2] + at[2]);
    for (int c = 0; c < 3; c++)
        point[c] += row[3 + c];
    return BATTEN_OK;
}

static batten_status place_points(const bat_run *run, const batten_lattice *l, double *points)
{
    const bat_argument *moves = bat_argument_of(run, "move"),
                       *all = bat_argument_of(run, "lattice");
    batten_status status = batten_lattice_home(l, points);
    if (status != BATTEN_OK)
        return status;
    const int count = l->counts[0] * l->counts[1] * l->counts[2];
    if (all->count > 0 && all->count != count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'lattice' has %d point%s, not %d x %d x %d = %d",
                        all->count, bat_plural(all->count), l->counts[0], l->counts[1],
                        l->counts[2], count);
    for (int i = 0; i < all->count; i++)
        memcpy(points + 3 * i, all->items[i].number, 3 * sizeof *points);
    for (int i = 0; i < moves->count && status == BATTEN_OK; i++)
        status = move_point(l, moves->items[i].number, i, points);
    return status;
}

static void report_map(const bat_run *run, const batten_deformation_report *r)
{
    if (r->folding == BATTEN_FOLDS_NOWHERE)
        bat_remark(run,
                   "the map folds nowhere: it multiplies volumes by more than %.3g; lattice "
                   "points move by up to %.4g",
                   r->bound, r->moved);
    if (r->folding == BATTEN_FOLDS_UNKNOWN)
        bat_note(run,
                 "it is not proved that the map folds nowhere: volumes are multiplied by %.3g "
                 "at least where it was looked at, near (%.4g, %.4g, %.4g), and by more than "
                 "%.3g everywhere",
                 r->least, r->at[0], r->at[1], r->at[2], r->bound);
}

static batten_status make_map(const bat_run *run, const bat_objects *objects,
                              batten_deformation **out)
{
    batten_lattice lattice;
    batten_deformation_options options = batten_deformation_defaults();
    batten_deformation_report report;
    options.join = (batten_box_join)bat_word(run, "outside");
    batten_status status = find_lattice(run, objects, &lattice);
    if (status != BATTEN_OK)
        return status;
    /* One too large is refused before there are points. */
    const int *n = lattice.counts;
    const double total = (double)n[0] * n[1] * n[2];
    const size_t room = total <= 1e6 ? (size_t)total : 1;
    double *points = bat_array(room, 3 * sizeof *points);
    status = points ? place_points(run, &lattice, points) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_deformation_create(&lattice, points, &options, &report, out);
    if (status == BATTEN_OK)
        report_map(run, &report);
    bat_release(points);
    return status;
}

/* ---- objects ---- */

typedef struct {
    const batten_deformation *map;
    double tolerance;
} task;

static batten_status deform_points(bat_run *run, const task *t, const batten_object *object)
{
    batten_object made = *object;
    double *points = bat_array((size_t)object->point_count, 3 * sizeof *points);
    batten_status status = points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_deformation_apply(
            t->map, (batten_points){3, object->point_count, object->points}, points);
    made.points = points;
    if (status == BATTEN_OK)
        status = bat_add(run, &made);
    bat_release(points);
    return status;
}

static batten_status deform_mesh(bat_run *run, const task *t, const batten_object *object)
{
    batten_object made = *object;
    batten_mesh *mesh = NULL;
    double error = 0;
    batten_status status = batten_mesh_deform(object->mesh, t->map, &error, &mesh);
    made.mesh = mesh;
    if (status == BATTEN_OK)
        status = bat_add(run, &made);
    if (status == BATTEN_OK && error > t->tolerance)
        bat_note(run,
                 "'%.60s': vertices move exactly; the middles of its sides are up to %.3g from "
                 "their images, more than %.3g: use finer triangles, or deform the surfaces "
                 "and 'mesh' them",
                 object->name, error, t->tolerance);
    batten_mesh_unref(mesh);
    return status;
}

static batten_status deform_body(bat_run *run, const task *t, const batten_object *object)
{
    batten_object made = *object;
    batten_body *body = NULL;
    double error = 0;
    batten_status status =
        batten_body_deform(object->body, t->map, t->tolerance, run->job, &error, &body);
    made.body = body;
    if (status == BATTEN_OK)
        status = bat_add(run, &made);
    if (status == BATTEN_OK)
        bat_report_error(run, error, error);
    batten_body_unref(body);
    return status;
}

static batten_status deform_shape(bat_run *run, const task *t, const batten_object *object)
{
    batten_curve *curve = NULL;
    batten_surface *surface = NULL;
    double error = 0;
    const bool is_curve = object->kind == BATTEN_OBJECT_CURVE;
    const batten_status status =
        is_curve
            ? batten_curve_deform(object->curve, t->map, t->tolerance, &error, &curve)
            : batten_surface_deform(object->surface, t->map, t->tolerance, &error, &surface);
    if (status == BATTEN_OK)
        bat_report_error(run, error, error);
    return is_curve ? bat_put_curve_like(run, status, curve, object, false)
                    : bat_put_surface_like(run, status, surface, object);
}

static batten_status deform_object(bat_run *run, const task *t, const batten_object *object)
{
    switch (object->kind) {
    case BATTEN_OBJECT_POINTS:
        return deform_points(run, t, object);
    case BATTEN_OBJECT_MESH:
        return deform_mesh(run, t, object);
    case BATTEN_OBJECT_BODY:
        return deform_body(run, t, object);
    default:
        return deform_shape(run, t, object);
    }
}

static batten_status run_deform(bat_run *run)
{
    batten_deformation *map = NULL;
    bat_objects objects;
    if (bat_has(run, "move") == bat_has(run, "lattice"))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a deformation needs either 'move' or 'lattice'");
    batten_status status = bat_gather(run, "deform", KINDS, &objects);
    if (status != BATTEN_OK)
        return status;
    status = make_map(run, &objects, &map);
    const task t = {map,
                    bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run)};
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++) {
        status = deform_object(run, &t, objects.at[i]);
        if (status != BATTEN_OK)
            status = bat_fail(status, "'%.60s': %s", objects.at[i]->name, batten_message());
    }
    batten_deformation_unref(map);
    bat_objects_release(&objects);
    return status;
}

const bat_feature bat_feature_deform = {
    .shown =
        {"deform", "Free-form deformation: shapes follow the lattice of a box",
         "Points in the box are drawn along by a lattice of control points, which stand evenly in\n"
         "it until they are moved: 'move: [[1, 2, 4, 0, 0, 0.3]]' lifts the first in x, second in\n"
         "y, fourth in z. With as many points as the degree and one more the map is one Bezier\n"
         "polynomial, with more a B-spline, and moves act locally. A map that folds is refused\n"
         "with the place; what cannot be proved is noted. Only local folds are looked for.\n"
         "Shapes that leave the box are refused; with 'outside' they stay as they are there, and\n"
         "one, two or three layers of lattice points must stay on the sides where they leave.\n"
         "Points and vertices of meshes move exactly. Curves and surfaces are fitted to their\n"
         "images, quintic and biquintic, within 'within', and the error is measured.",
         "features:\n"
         "  hull: {cylinder: 0.5 m, height: 3 m}\n"
         "  bent: {deform: hull, counts: [2, 2, 4], move: [[1, 1, 4, 0.6 m, 0, 0],\n"
         "         [1, 2, 4, 0.6 m, 0, 0], [2, 1, 4, 0.6 m, 0, 0], [2, 2, 4, 0.6 m, 0, 0]]}\n",
         "[SP86] [GP89]", "batten_deformation_create", BAT_PARAMETERS(parameters), false,
         .also =
             "free-form deformation, FFD, cage, lattice, warp, bend, taper, morph, trivariate "
             "B-spline, Bezier volume, Sederberg, Parry",
         .formula = "    D(x) = Σ_ijk N_i(s) N_j(t) N_k(r) P_ijk,  x = (s, t, r) in the box;  "
                    "det D′ > 0",
         .promise = "The map folds nowhere, or is refused; curves and surfaces are as near to "
                    "their images as is reported."},
    .run = run_deform,
    .displacing = "deform"};
