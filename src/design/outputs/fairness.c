/* What a check finds: distances from the data, fairness of sections, edges off the centre plane. */
#include "design/outputs/fairness.h"
#include "design/shared/rows.h"
#include "design/shared/through.h"

#include <batten/continuity.h>
#include <string.h>

#define EDGE_POINTS 101

/* ---- edges ---- */

static batten_status add_edge(bat_checked *checked, batten_direction direction, bool high)
{
    const batten_surface *surface = checked->object->surface;
    const batten_interval domain = batten_surface_domain(surface, direction);
    const batten_direction other = direction == BATTEN_U ? BATTEN_V : BATTEN_U;
    const batten_interval along = batten_surface_domain(surface, other);
    const double fixed = high ? domain.b : domain.a;
    bat_edge edge = {bat_side_name(checked->object, 2 * (direction == BATTEN_V) + high), 0,
                     false};
    double sum = 0;
    for (int i = 0; i < EDGE_POINTS; i++) {
        const double t = along.a + (along.b - along.a) * i / (EDGE_POINTS - 1);
        double p[3] = {0, 0, 0};
        const batten_status status = direction == BATTEN_U
                                         ? batten_surface_evaluate(surface, fixed, t, 0, p)
                                         : batten_surface_evaluate(surface, t, fixed, 0, p);
        if (status != BATTEN_OK)
            return status;
        edge.gap = bat_max(edge.gap, fabs(p[1]));
        sum += fabs(p[1]);
    }
    const batten_box box = batten_surface_box(surface);
    const double breadth = bat_max(fabs(box.low.y), fabs(box.high.y));
    edge.is_near = sum / EDGE_POINTS <= breadth / 20;
    checked->edges[checked->edge_count++] = edge;
    return BATTEN_OK;
}

/* ---- objects ---- */

/* A surface that folds over needs no points to be judged. */
static batten_status find_fold(bat_check *check, bat_checked *checked)
{
    const batten_surface *surface = checked->object->surface;
    if (batten_surface_dimension(surface) != 3)
        return BATTEN_OK;
    const batten_status status = batten_surface_find_fold(surface, &checked->fold);
    check->unfairness.folds += checked->fold.found;
    check->judged_count += checked->fold.found;
    return status;
}

static batten_status check_surface(bat_check *check, bat_checked *checked)
{
    batten_status status = bat_check_add_distances(check, checked);
    if (status == BATTEN_OK)
        status = find_fold(check, checked);
    if (status == BATTEN_OK)
        status = bat_check_add_sections(check, checked);
    for (int i = 0; i < 4 && status == BATTEN_OK && checked->is_hull; i++)
        status = add_edge(checked, i < 2 ? BATTEN_U : BATTEN_V, i % 2);
    return status;
}

/* The points that a curve was made from, and the curve. */
static batten_status add_curve_distance(bat_check *check, bat_checked *checked)
{
    const batten_object *object = checked->object;
    const int d = batten_curve_dimension(object->curve);
    batten_deviation deviation;
    double *points = bat_array3((size_t)object->point_count, (size_t)d, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < object->point_count; i++)
        memcpy(points + i * d, object->points + 3 * i, (size_t)d * sizeof *points);
    const batten_status status = batten_curve_deviation(
        object->curve,
        (batten_points){batten_curve_dimension(object->curve), object->point_count, points},
        NULL, check->run->job, NULL, &deviation);
    bat_release(points);
    if (status != BATTEN_OK)
        return status;
    bat_data_distance *to = bat_arena_array(&check->arena, 1, sizeof *to);
    if (!to)
        return BATTEN_OUT_OF_MEMORY;
    checked->distances = to;
    checked->distance_count = 1;
    *to = (bat_data_distance){.feature = object->name,
                              .is_faired = bat_check_is_faired(checked),
                              .count = object->point_count,
                              .max = deviation.max,
                              .rms = deviation.rms};
    memcpy(to->worst, object->points + 3 * deviation.worst, sizeof to->worst);
    check->ok &= to->is_faired || to->max <= check->within;
    check->bounded_count += !to->is_faired;
    return BATTEN_OK;
}

/* How smooth the curve is at its own knots. */
static batten_status add_knots(const bat_check *check, bat_checked *checked)
{
    batten_continuities joins;
    batten_curve_continuity_options options = batten_curve_continuity_defaults();
    options.gap = bat_tolerance(check->run);
    const batten_status status =
        batten_curve_continuity(checked->object->curve, &options, &joins);
    if (status != BATTEN_OK)
        return status;
    checked->knot_count = joins.count;
    checked->parametric = checked->geometric = 3;
    for (int k = 0; k < joins.count; k++) {
        checked->parametric = bat_min_int(checked->parametric, joins.at[k].parametric);
        checked->geometric = bat_min_int(checked->geometric, joins.at[k].geometric);
    }
    batten_release(joins.at);
    return BATTEN_OK;
}

static void add_unfairness(bat_unfairness *sum, const batten_fairness *f)
{
    sum->corners += f->corners;
    sum->curvature_jumps += f->curvature_jumps;
    sum->unbounded += f->unbounded;
    sum->largest_turn = bat_max(sum->largest_turn, f->largest_turn);
}

bool bat_check_is_fair(const bat_check *check)
{
    const bat_unfairness *u = &check->unfairness;
    return u->corners == 0 && u->curvature_jumps == 0 && u->inflections == 0 &&
           u->unbounded == 0 && u->joint_corners == 0 && u->joint_jumps == 0 &&
           u->creases == 0 && u->edge_jumps == 0 && u->folds == 0;
}

/* Inflections in excess of the edges of what was lofted, which no family of sections shows. */
static void judge_lofts(bat_check *check)
{
    for (int i = 0; i < check->run->document->feature_count; i++) {
        const batten_loft_report *loft = check->run->results[i].shown.loft;
        for (int k = 0; check->upstream[i] && loft && k < loft->cut_count; k++) {
            const batten_loft_cut *cut = loft->cuts + k;
            const int excess = cut->found - cut->needed;
            if (cut->family >= BATTEN_LOFT_PROFILE && excess > 0)
                check->unfairness.inflections += excess;
        }
    }
}

/* Panels of one lofting meet where the designer declared a knuckle: the upper edge of one and the
 * lower of the next, all along. */
static bool is_declared(const bat_check *check, const bat_join *join)
{
    const bat_checked *a = check->objects + join->of.shape[0],
                      *b = check->objects + join->of.shape[1];
    const int v_low = 2, v_high = 3; /* sides, as of bat_side_name */
    const int low = bat_min_int(join->of.side[0], join->of.side[1]),
              high = bat_max_int(join->of.side[0], join->of.side[1]);
    return a != b && a->panels_of >= 0 && a->panels_of == b->panels_of && join->of.part < 0 &&
           low == v_low && high == v_high;
}

/* Where more than two ends meet nothing says which curves make one line; a curve may begin and end in a corner, as an
 * aerofoil at its trailing edge. */
static void judge_ends(bat_check *check, const bat_join *join)
{
    bat_unfairness *u = &check->unfairness;
    if (join->is_branch || join->of.shape[0] == join->of.shape[1] ||
        !isfinite(join->of.angle.value))
        return;
    if (join->of.angle.value > check->curve_bounds.angle) {
        u->joint_corners++;
        u->largest_joint = bat_max(u->largest_joint, join->of.angle.value);
    } else if (join->of.curvature.value > check->curve_bounds.curvature) {
        u->joint_jumps++;
    }
}

/* Of whole edges of surfaces. A knuckle that the bound allows, or that is declared, has no common
 * curvature. */
static void judge_edges(bat_check *check, const bat_join *join)
{
    bat_unfairness *u = &check->unfairness;
    check->judged_count++;
    u->largest_crease = bat_max(u->largest_crease, join->of.angle.value);
    if (join->of.angle.value > check->edge_bounds.angle)
        u->creases++;
    else if (join->of.angle.value <= BAT_EDGE_ANGLE &&
             join->of.curvature.value > check->edge_bounds.curvature)
        u->edge_jumps++;
}

static void judge_join(bat_check *check, bat_join *join)
{
    const batten_object_kind kind = check->objects[join->of.shape[0]].object->kind;
    join->is_knuckle = is_declared(check, join);
    if (join->is_knuckle)
        check->judged_count++;
    else if (kind == BATTEN_OBJECT_CURVE)
        judge_ends(check, join);
    else if (kind == BATTEN_OBJECT_SURFACE && isfinite(join->of.angle.value))
        judge_edges(check, join);
}

static void judge_joins(bat_check *check)
{
    for (int i = 0; i < check->join_count; i++)
        judge_join(check, &check->joins[i]);
}

/* A curve and its points, as they were given, in the plane that they lie in. */
typedef struct {
    bool is_plane; /* else they are in space */
    batten_curve *curve;
    double *data; /* [point_count][dimension of the curve]; NULL for none */
} plane_view;

static void close_view(plane_view *view)
{
    bat_release(view->data);
    batten_curve_unref(view->curve);
}

static batten_status open_view(const bat_check *check, const bat_checked *checked,
                               double *bound, plane_view *view)
{
    const batten_object *object = checked->object;
    const int count = object->point_count;
    const int axis = count ? bat_flat_axis(count, object->points) : -1;
    batten_affine oblique;
    batten_status status =
        bat_check_given_row(check, checked, count, object->points, axis, &view->data, bound);
    view->is_plane = axis >= 0;
    if (status == BATTEN_OK && count && axis < 0 &&
        batten_curve_dimension(object->curve) == 3 &&
        bat_plane_find(batten_curve_point_count(object->curve),
                       batten_curve_points(object->curve), &oblique)) {
        view->is_plane = true;
        bat_plane_points(&oblique, count, view->data, view->data);
        return bat_plane_curve(&oblique, object->curve, &view->curve);
    }
    return status == BATTEN_OK ? bat_curve_in_plane(object->curve, axis, &view->curve) : status;
}

/* Inflections count against the points as they were given; without points in a plane only
 * corners, cusps and jumps count. */
static batten_status judge_curve(bat_check *check, bat_checked *checked)
{
    const batten_object *object = checked->object;
    batten_fairness_options options = batten_fairness_defaults();
    plane_view view = {false, NULL, NULL};
    batten_status status = open_view(check, checked, &options.within, &view);
    options.angle = check->curve_bounds.angle;
    options.curvature = check->curve_bounds.curvature;
    options.error = bat_chain_error(check->run, object);
    if (status == BATTEN_OK)
        status = batten_curve_fairness(view.curve,
                                       (batten_points){batten_curve_dimension(view.curve),
                                                       object->point_count,
                                                       object->point_count ? view.data : NULL},
                                       &options, &checked->fairness);
    checked->has_fairness = status == BATTEN_OK;
    if (checked->has_fairness) {
        add_unfairness(&check->unfairness, &checked->fairness);
        check->unfairness.inflections +=
            view.is_plane ? checked->fairness.excess_inflections : 0;
        check->judged_count++;
    }
    close_view(&view);
    return status;
}

static bool has_own_points(const batten_object *object)
{
    return object->point_count && !object->points_are_vertices;
}

static batten_status check_curve(bat_check *check, bat_checked *checked)
{
    batten_status status = judge_curve(check, checked);
    if (status == BATTEN_OK)
        status = add_knots(check, checked);
    if (status != BATTEN_OK)
        return status;
    if (has_own_points(checked->object))
        return add_curve_distance(check, checked);
    return bat_check_is_cut(checked) ? bat_check_add_distances(check, checked) : BATTEN_OK;
}

/* How a set of triangles hangs together. */
static batten_status check_triangles(const bat_check *check, bat_checked *checked)
{
    batten_triangle_joins joins = {0, NULL};
    const batten_status status =
        batten_triangles_joins(checked->object->triangles, bat_tolerance(check->run), &joins);
    if (status != BATTEN_OK)
        return status;
    checked->triangle_joins = joins.count;
    for (int i = 0; i < joins.count; i++) {
        checked->triangle_gap = bat_max(checked->triangle_gap, joins.at[i].gap);
        checked->triangle_angle = bat_max(checked->triangle_angle, joins.at[i].angle);
    }
    batten_triangle_joins_release(&joins);
    return BATTEN_OK;
}

static bool is_solid(const batten_object *object)
{
    return object->kind == BATTEN_OBJECT_BODY || object->kind == BATTEN_OBJECT_MESH;
}

/* With a bound, gaps of bodies must not be wider than it, and their faces must fit together. */
static batten_status check_solid(bat_check *check, bat_checked *checked)
{
    const batten_object *object = checked->object;
    const bool has_bound = isfinite(check->within);
    const batten_status status =
        bat_check_solid(check->run, object, has_bound ? check->within : 0, &checked->faults);
    if (status != BATTEN_OK || !has_bound)
        return status;
    check->bounded_count++;
    if (bat_solid_holds(object, &checked->faults))
        return BATTEN_OK;
    check->ok = false;
    if (object->kind == BATTEN_OBJECT_MESH)
        bat_note(check->run, "'%.60s' is a mesh that is not closed", object->name);
    else
        bat_note(check->run, "'%.60s' has faults beyond %g", object->name, check->within);
    return BATTEN_OK;
}

static batten_status check_object(bat_check *check, bat_checked *checked)
{
    switch (checked->object->kind) {
    case BATTEN_OBJECT_SURFACE:
        return check_surface(check, checked);
    case BATTEN_OBJECT_CURVE:
        return check_curve(check, checked);
    case BATTEN_OBJECT_TRIANGLES:
        return check_triangles(check, checked);
    default:
        return is_solid(checked->object) ? check_solid(check, checked) : BATTEN_OK;
    }
}

batten_status bat_check_all(const bat_run *run, const char *parameter, double within,
                            const bat_fair_bounds *curves, const bat_fair_bounds *edges,
                            bat_check *out)
{
    bat_objects objects = {0, NULL};
    *out = (bat_check){.run = run,
                       .within = within,
                       .ok = true,
                       .curve_bounds = *curves,
                       .edge_bounds = *edges};
    batten_status status = bat_gather(run, parameter, BAT_ALL, &objects);
    if (status != BATTEN_OK)
        return status;
    out->object_count = objects.count;
    out->objects = bat_arena_array(&out->arena, (size_t)objects.count, sizeof *out->objects);
    if (!out->objects)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        out->objects[i].object = objects.at[i];
    if (status == BATTEN_OK)
        status = bat_check_trace(out, parameter);
    if (status == BATTEN_OK)
        status = bat_check_cuts(out);
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = check_object(out, &out->objects[i]);
    if (status == BATTEN_OK)
        status = bat_joins_find(out);
    if (status == BATTEN_OK) {
        judge_joins(out);
        judge_lofts(out);
    }
    bat_objects_release(&objects);
    return status;
}

void bat_check_release(bat_check *check)
{
    bat_release(check->joins);
    bat_arena_free(&check->arena);
}
