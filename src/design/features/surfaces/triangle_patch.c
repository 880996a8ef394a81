/* The feature 'triangle-patch': the surface between three curves. */
#include "design/shared/smooth.h"

#include <batten/coons.h>
#include <batten/fill.h>

enum { MOST_NEIGHBOURS = 10000 };

static const batten_parameter parameters[] = {
    {"triangle-patch", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the three curves, in any order and direction"},
    {"method", BATTEN_VALUE_WORD, false, false, "side-vertex", "side-vertex parallels corners",
     "after Nielson; Barnhill, Birkhoff and Gordon; Charrot and Gregory"},
    {"along", BATTEN_VALUE_MODEL, true, false, NULL, NULL,
     "surfaces or Bezier triangles beside the curves, whose tangent planes it takes over"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "of corners, and of curves and edges; the tolerance of the design by default"},
    {"angle", BATTEN_VALUE_ANGLE, false, false, "0.1 deg", NULL,
     "between curves, or the spline, and the tangent planes that are taken over"},
};

/* The curves over [0, 1], or the edges of the surfaces that lie beside them, with slopes. */
typedef struct {
    batten_ribbon ribbons[3];
    batten_curve *owned[3][2];
    batten_surface *beside[3];
    batten_loop_place places[3];
    double within;
} sides;

static void sides_release(sides *all)
{
    for (int i = 0; i < 3; i++) {
        batten_surface_unref(all->beside[i]);
        for (int k = 0; k < 2; k++)
            batten_curve_unref(all->owned[i][k]);
    }
}

/* A plane curve is one of space. */
static batten_status take_curve(const batten_curve *curve, batten_curve **out)
{
    batten_curve *space = NULL;
    batten_status status = batten_curve_to_dimension(curve, 3, &space);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(space, 0, 1, out);
    batten_curve_unref(space);
    return status;
}

static batten_status take_curves(const bat_objects *curves, sides *all)
{
    if (curves->count != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a triangle lies between 3 curves, not %d",
                        curves->count);
    const batten_curve *loop[3];
    batten_status status = BATTEN_OK;
    for (int i = 0; i < 3 && status == BATTEN_OK; i++) {
        status = take_curve(curves->at[i]->curve, &all->owned[i][0]);
        loop[i] = all->owned[i][0];
        all->ribbons[i] = (batten_ribbon){loop[i], NULL, NULL};
    }
    return status == BATTEN_OK ? batten_curves_loop(3, loop, all->within, all->places) : status;
}

/* ---- slopes ---- */

/* The derivative of the side at a place of the loop, where that side begins or ends. */
static batten_status tangent_at(const sides *all, int place, bool at_end, double out[3])
{
    const batten_loop_place *p = &all->places[place];
    double d[6];
    const batten_status status =
        batten_curve_evaluate(all->owned[p->curve][0], at_end != p->reversed, 1, d);
    for (int c = 0; c < 3; c++)
        out[c] = p->reversed ? -d[3 + c] : d[3 + c];
    return status;
}

/* The inward tangents at t = 0 and 1 of the side at a place, those of its neighbours. */
static batten_status inward_tangents(const sides *all, int place, double ends[2][3])
{
    const bool reversed = all->places[place].reversed;
    double *start = ends[reversed], *end = ends[!reversed];
    batten_status status = tangent_at(all, (place + 2) % 3, true, start);
    if (status == BATTEN_OK)
        status = tangent_at(all, (place + 1) % 3, false, end);
    for (int c = 0; c < 3; c++)
        start[c] = -start[c];
    return status;
}

/* What may lie beside a curve: the surfaces, and of triangles a half at each edge. */
typedef struct {
    bat_objects objects;
    int count;
    batten_surface **surfaces;
    int *owner;    /* [count] which object */
    bool *touched; /* by object */
} neighbours;

static void neighbours_release(neighbours *all)
{
    for (int i = 0; i < all->count; i++)
        batten_surface_unref(all->surfaces[i]);
    bat_release(all->surfaces);
    bat_release(all->owner);
    bat_release(all->touched);
    bat_objects_release(&all->objects);
}

static batten_status add_neighbour(neighbours *all, int owner, int part)
{
    const batten_object *object = all->objects.at[owner];
    all->owner[all->count] = owner;
    if (object->surface) {
        all->surfaces[all->count++] = batten_surface_ref(object->surface);
        return BATTEN_OK;
    }
    const batten_status status = batten_triangles_half_at_edge(
        object->triangles, part / 3, part % 3, &all->surfaces[all->count]);
    all->count += status == BATTEN_OK;
    return status;
}

static int parts_of(const batten_object *object)
{
    return object->surface ? 1 : 3 * batten_triangles_count(object->triangles);
}

static batten_status find_neighbours(const bat_run *run, neighbours *all)
{
    long long count = 0;
    batten_status status =
        bat_gather(run, "along", BAT_SURFACES | BAT_TRIANGLES, &all->objects);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < all->objects.count; i++)
        count += parts_of(all->objects.at[i]);
    if (count > MOST_NEIGHBOURS)
        return bat_fail(
            BATTEN_TOO_LARGE,
            "%lld surfaces and edges of triangles beside the curves; the limit is %d", count,
            MOST_NEIGHBOURS);
    all->surfaces = bat_array((size_t)count, sizeof(batten_surface *));
    all->owner = bat_array((size_t)count, sizeof *all->owner);
    all->touched = bat_array((size_t)all->objects.count, sizeof *all->touched);
    if (!all->surfaces || !all->owner || !all->touched)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < all->objects.count; i++)
        for (int k = 0; k < parts_of(all->objects.at[i]) && status == BATTEN_OK; k++)
            status = add_neighbour(all, i, k);
    return status;
}

/* The slope of the first one that has the side at a place of the loop as its edge. */
static batten_status take_slope(bat_run *run, neighbours *beside, int place, sides *all)
{
    const int i = all->places[place].curve;
    double ends[2][3];
    batten_status status = inward_tangents(all, place, ends);
    for (int k = 0; k < beside->count && status == BATTEN_OK; k++) {
        batten_curve *ribbon[2] = {NULL, NULL};
        double error = 0;
        status = batten_ribbon_along(beside->surfaces[k], all->owned[i][0],
                                     (batten_ribbon_wish){1, ends[0], all->within}, NULL,
                                     &error, ribbon);
        if (status == BATTEN_NOT_FOUND) {
            status = BATTEN_OK;
            continue;
        }
        if (status != BATTEN_OK)
            break;
        beside->touched[beside->owner[k]] = true;
        for (int c = 0; c < 2; c++) {
            batten_curve_unref(all->owned[i][c]);
            all->owned[i][c] = ribbon[c];
        }
        all->ribbons[i] = (batten_ribbon){ribbon[0], ribbon[1], NULL};
        all->beside[i] = batten_surface_ref(beside->surfaces[k]);
        if (error > 0)
            bat_report_error(run, error, error);
        break;
    }
    return status;
}

static batten_status take_slopes(bat_run *run, sides *all)
{
    neighbours beside = {.count = 0};
    batten_status status = find_neighbours(run, &beside);
    for (int place = 0; place < 3 && status == BATTEN_OK; place++)
        status = take_slope(run, &beside, place, all);
    for (int i = 0; i < beside.objects.count && status == BATTEN_OK; i++)
        if (!beside.touched[i])
            bat_note(run, "'%s' has none of the curves as its edge, within %g",
                     beside.objects.at[i]->name, all->within);
    neighbours_release(&beside);
    return status;
}

/* The first curve is the side opposite the pole at u = 0; the others come to it in v = 0, 1. */
static bat_smooth_wish smooth_wish(const bat_run *run, const bat_objects *curves,
                                   const sides *all)
{
    bat_smooth_wish wish = {.within = all->within, .angle = bat_number(run, "angle")};
    static const batten_edge edges[3] = {BATTEN_EDGE_U1, BATTEN_EDGE_V1, BATTEN_EDGE_V0};
    for (int place = 0; place < 3; place++) {
        const int i = all->places[place].curve;
        wish.names[edges[place]] = all->ribbons[i].slope ? curves->at[i]->name : NULL;
        wish.beside[edges[place]] = all->beside[i];
    }
    return wish;
}

static batten_status run_triangle_patch(bat_run *run)
{
    bat_objects curves;
    sides all = {.within =
                     bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run)};
    batten_surface *surface = NULL;
    batten_status status = bat_gather(run, "triangle-patch", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    status = take_curves(&curves, &all);
    if (status == BATTEN_OK && bat_has(run, "along"))
        status = take_slopes(run, &all);
    if (status == BATTEN_OK)
        status =
            batten_triangle_patch(all.ribbons, (batten_triangle_method)bat_word(run, "method"),
                                  all.within, bat_number(run, "angle"), &surface);
    if (bat_has(run, "along")) {
        const bat_smooth_wish wish = smooth_wish(run, &curves, &all);
        status = bat_put_smooth_surface(run, status, surface, &wish);
    } else {
        status = bat_put_surface(run, status, surface);
    }
    bat_objects_release(&curves);
    sides_release(&all);
    return status;
}

const bat_feature bat_feature_triangle_patch = {
    .shown =
        {"triangle-patch", "The surface between three curves",
         "A formula that meets the whole curves, and with 'along' the tangent planes of the\n"
         "surfaces beside them; the result is a NURBS surface within the tolerance of it. All\n"
         "three methods reproduce whatever is cubic over a triangle. 'side-vertex' draws lines\n"
         "from each side to the corner opposite, 'parallels' lines parallel to the sides;\n"
         "'corners' blends expansions about each corner with polynomials: in the corner between\n"
         "three cylinders of radius 1 the three methods deviate from the ball by 0.063, 0.041 and\n"
         "0.016. The first curve is the side opposite the pole of the parameters.",
         "features:\n"
         "  a: {polyline: [[0, 0, 0], [2 m, 0, 0.2 m]]}\n"
         "  b: {polyline: [[2 m, 0, 0.2 m], [1 m, 1.8 m, 0]]}\n"
         "  c: {polyline: [[1 m, 1.8 m, 0], [0, 0, 0]]}\n"
         "  sail: {triangle-patch: [a, b, c]}\n",
         "[Utah74 paper 3] [Utah74 paper 11] [Nielson79] [BarnhillBirkhoffGordon73] [CharrotGregory80]",
         "batten_triangle_patch", BAT_PARAMETERS(parameters), false,
         .also =
             "Nielson, side-vertex, Barnhill, three-sided patch, Barnhill-Birkhoff-Gordon, Charrot-Gregory",
         .formula =
             "    side-vertex: P = (b2² b3² D1 + b3² b1² D2 + b1² b2² D3)/(b2² b3² + b3² b1² + b1² b2²),  D_i cubics of Hermite from corner to side",
         .promise =
             "The sides are met, with along also the tangent planes; cubics are reproduced."},
    .run = run_triangle_patch,
    .beside = "along"};
