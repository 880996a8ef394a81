/* What a check finds: distances from the data, fairness of sections, edges off the centre plane. */
#include "design/outputs/fairness.h"
#include "design/shared/rows.h"

#include <batten/continuity.h>
#include <string.h>

/* Cells of the grid on which sections are sought, and the points by which one is judged. */
#define SECTION_CELLS 64
#define SECTION_POINTS 61
#define EDGE_POINTS 101

/* ---- data ---- */

static bool has_data(const batten_model *model)
{
    for (int i = 0; model && i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->kind == BATTEN_OBJECT_OFFSET_TABLE || object->point_count)
            return true;
    }
    return false;
}

/* Does a feature place its result away from the points of its inputs? */
static bool displaces(const bat_entry *entry)
{
    const batten_feature *shown = &entry->feature->shown;
    const char *displacing = entry->feature->displacing;
    for (int k = 0; displacing && k < shown->parameter_count; k++)
        if (strcmp(shown->parameters[k].name, displacing) == 0)
            return entry->arguments[k].count > 0;
    return false;
}

/* The first feature upstream that has points, and the last that made points fair; none when
 * sections were displaced since, for then distances from them mean nothing. */
static void find_data(const bat_check *check, const bool *upstream, int *given, int *faired)
{
    const bat_document *d = check->run->document;
    *given = *faired = -1;
    for (int i = 0; i < d->feature_count; i++)
        if (upstream[i] && displaces(&d->features[i]))
            return;
    for (int k = 0; k < d->feature_count; k++) {
        const int i = d->order[k];
        if (!upstream[i] || !has_data(check->run->results[i].value))
            continue;
        if (check->run->results[i].shown.has_moves)
            *faired = i;
        else if (*given < 0)
            *given = i;
    }
}

/* The data of the objects that come of one feature of the argument: the `count` from `first`
 * on.
 */
static batten_status trace_feature(bat_check *check, bat_graph *graph, int feature, int first,
                                   int count)
{
    const int feature_count = check->run->document->feature_count;
    bool *upstream = bat_array((size_t)feature_count, sizeof *upstream);
    batten_status status =
        upstream ? bat_graph_mark(graph, feature, upstream) : BATTEN_OUT_OF_MEMORY;
    int given = -1, faired = -1;
    if (status == BATTEN_OK)
        find_data(check, upstream, &given, &faired);
    for (int i = 0; status == BATTEN_OK && i < feature_count; i++)
        check->upstream[i] |= upstream[i];
    for (int i = first; i < first + count; i++) {
        check->objects[i].given = given;
        check->objects[i].faired = faired;
    }
    bat_release(upstream);
    return status;
}

/* What each object was made from; the objects stand in the order of the argument. */
static batten_status trace_objects(bat_check *check, const char *parameter)
{
    const bat_argument *argument = bat_argument_of(check->run, parameter);
    bat_graph graph;
    check->upstream = bat_arena_array(
        &check->arena, (size_t)check->run->document->feature_count, sizeof *check->upstream);
    if (!check->upstream)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = bat_document_graph(check->run->document, &graph);
    if (status != BATTEN_OK)
        return status;
    int first = 0;
    for (int i = 0; i < argument->count && status == BATTEN_OK; i++) {
        const int feature = argument->items[i].count;
        const int count = batten_model_count(check->run->results[feature].value);
        status = trace_feature(check, &graph, feature, first, count);
        first += count;
    }
    assert(status != BATTEN_OK || first == check->object_count);
    bat_graph_release(&graph);
    return status;
}

/* ---- rows of a feature ---- */

typedef batten_status (*row_visit)(void *context, const bat_row *row);

static batten_status visit_object(const batten_object *object, bool lines, row_visit visit,
                                  void *context)
{
    bat_rows rows = {0, NULL};
    batten_status status = bat_rows_of(object, lines, &rows);
    for (int i = 0; i < rows.count && status == BATTEN_OK; i++)
        status = visit(context, &rows.rows[i]);
    bat_rows_release(&rows);
    return status;
}

/* Every row of a feature; the lines of a table too when `with_lines`. */
static batten_status visit_rows(const bat_check *check, int feature, bool with_lines,
                                row_visit visit, void *context)
{
    const batten_model *model = check->run->results[feature].value;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_model_count(model) && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(model, i);
        status = visit_object(object, false, visit, context);
        if (status == BATTEN_OK && with_lines && object->kind == BATTEN_OBJECT_OFFSET_TABLE)
            status = visit_object(object, true, visit, context);
    }
    return status;
}

/* ---- distances ---- */

typedef struct {
    int count, capacity;
    double *points;
} cloud;

static batten_status add_to_cloud(void *context, const bat_row *row)
{
    cloud *c = context;
    if (row->count == 0)
        return BATTEN_OK;
    double *grown = bat_resize(c->points, 3 * (size_t)(c->count + row->count), sizeof *grown);
    if (!grown)
        return BATTEN_OUT_OF_MEMORY;
    c->points = grown;
    memcpy(grown + 3 * c->count, row->points, 3 * (size_t)row->count * sizeof *grown);
    c->count += row->count;
    return BATTEN_OK;
}

/* Of each point its distance from the nearest of the surfaces made from the same data. */
static batten_status nearest_surface(const bat_check *check, const bat_checked *checked,
                                     const cloud *all, double *nearest, double *distances)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < all->count; i++)
        nearest[i] = HUGE_VAL;
    for (int k = 0; k < check->object_count && status == BATTEN_OK; k++) {
        const batten_surface *surface = check->objects[k].object->surface;
        batten_deviation deviation;
        if (!surface || check->objects[k].given != checked->given ||
            check->objects[k].faired != checked->faired)
            continue;
        status = batten_surface_deviation(surface, (batten_points){3, all->count, all->points},
                                          NULL, check->run->job, distances, &deviation);
        for (int i = 0; status == BATTEN_OK && i < all->count; i++)
            nearest[i] = bat_min(nearest[i], distances[i]);
    }
    return status;
}

static bat_data_distance sum_up(const char *feature, const cloud *all, const double *nearest)
{
    bat_data_distance sum = {.feature = feature, .count = all->count};
    double squares = 0;
    int worst = 0;
    for (int i = 0; i < all->count; i++) {
        squares += nearest[i] * nearest[i];
        worst = nearest[i] > nearest[worst] ? i : worst;
    }
    sum.max = nearest[worst];
    sum.rms = sqrt(squares / all->count);
    memcpy(sum.worst, all->points + 3 * worst, sizeof sum.worst);
    return sum;
}

static batten_status add_distance(bat_check *check, bat_checked *checked, int feature)
{
    cloud all = {0, 0, NULL};
    if (feature < 0)
        return BATTEN_OK;
    batten_status status = visit_rows(check, feature, false, add_to_cloud, &all);
    double *nearest = bat_array3((size_t)all.count, 2, sizeof *nearest);
    if (status == BATTEN_OK && !nearest)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && all.count > 0)
        status = nearest_surface(check, checked, &all, nearest, nearest + all.count);
    if (status == BATTEN_OK && all.count > 0) {
        bat_data_distance *d = &checked->distances[checked->distance_count++];
        *d = sum_up(check->run->document->features[feature].name, &all, nearest);
        d->is_faired = feature == checked->faired;
        check->ok &= d->is_faired || d->max <= check->within;
        check->bounded_count += !d->is_faired;
    }
    bat_release(nearest);
    bat_release(all.points);
    return status;
}

/* ---- sections ---- */

typedef struct {
    bat_check *check;
    bat_checked *checked;
} section_context;

static batten_status count_section(void *context, const bat_row *row)
{
    bat_checked *checked = ((section_context *)context)->checked;
    checked->section_count += row->count >= 3 && bat_flat_axis(row->count, row->points) >= 0;
    return BATTEN_OK;
}

static const batten_polyline *longest(const batten_polylines *lines)
{
    const batten_polyline *found = NULL;
    for (int i = 0; i < lines->count; i++)
        if (!found || lines->lines[i].count > found->count)
            found = &lines->lines[i];
    return found;
}

/* Some points of a section, evenly taken, in its plane. @param[out] plane [SECTION_POINTS][2]
 */
static int thin(const batten_polyline *line, int axis, double *plane)
{
    const int count = bat_min_int(line->count, SECTION_POINTS);
    for (int i = 0; i < count; i++) {
        const double *p = line->points + 3 * (size_t)(i * (line->count - 1) / (count - 1));
        for (int k = 0, c = 0; k < 3; k++)
            if (k != axis)
                plane[2 * i + c++] = p[k];
    }
    return count;
}

/* How far points first .. last bulge from the chord of their outer neighbours. */
static double bulge(const double *points, int first, int last)
{
    const double *a = points + 2 * (first - 1), *b = points + 2 * (last + 1);
    const double x = b[0] - a[0], y = b[1] - a[1], length = hypot(x, y);
    double height = 0;
    for (int i = first; i <= last; i++) {
        const double dx = points[2 * i] - a[0], dy = points[2 * i + 1] - a[1];
        const double h = length > 0 ? fabs(x * dy - y * dx) / length : hypot(dx, dy);
        height = bat_max(height, h);
    }
    return height;
}

static int turning(const double *p)
{
    const double turn = (p[0] - p[-2]) * (p[3] - p[1]) - (p[1] - p[-1]) * (p[2] - p[0]);
    return (turn > 0) - (turn < 0);
}

int bat_visible_inflections(int count, const double *points, double height)
{
    int found = 0, before = 0;
    for (int first = 1, last; first < count - 1; first = last + 1) {
        const int sign = turning(points + 2 * first);
        for (last = first; last + 1 < count - 1 && turning(points + 2 * (last + 1)) == sign;)
            last++;
        if (sign == 0 || bulge(points, first, last) <= height)
            continue;
        found += before && sign != before;
        before = sign;
    }
    return found;
}

/* Judge a section by the curve through its points, and the inflections that the row needs. */
static batten_status judge(const batten_polyline *line, int axis, const bat_row *row,
                           double tolerance, bat_section *section)
{
    double plane[2 * SECTION_POINTS];
    batten_curve *curve = NULL;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_CHORD;
    const int count = thin(line, axis, plane);
    batten_status status =
        batten_curve_interpolate((batten_points){2, count, plane}, &options, NULL, &curve);
    double *data = bat_points_in_plane(axis, row->count, row->points);
    if (status == BATTEN_OK && !data)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_fairness(
            curve, (batten_points){batten_curve_dimension(curve), row->count, data},
            &section->fairness);
    section->found = status == BATTEN_OK;
    section->visible = bat_visible_inflections(count, plane, tolerance);
    section->excess = bat_max_int(0, section->visible - (section->fairness.inflections -
                                                         section->fairness.excess_inflections));
    bat_release(data);
    batten_curve_unref(curve);
    return status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED ? status : BATTEN_OK;
}

static batten_status add_section(void *context, const bat_row *row)
{
    static const char *const families[] = {"station", "buttock", "waterline"};
    const section_context *c = context;
    const int axis = bat_flat_axis(row->count, row->points);
    if (row->count < 3 || axis < 0)
        return BATTEN_OK;
    bat_section *section = &c->checked->sections[c->checked->section_count++];
    const char *name = bat_arena_copy(&c->check->arena, row->name, strlen(row->name));
    if (!name)
        return BATTEN_OUT_OF_MEMORY;
    *section = (bat_section){.family = families[axis], .name = name, .at = row->points[axis]};
    batten_polylines lines = {0, NULL};
    batten_status status = batten_surface_section(
        c->checked->object->surface, (batten_vec3){axis == 0, axis == 1, axis == 2},
        section->at, SECTION_CELLS, SECTION_CELLS, &lines);
    if (status != BATTEN_OK)
        return status;
    const batten_polyline *line = longest(&lines);
    if (line && line->count >= 4)
        status = judge(line, axis, row, bat_tolerance(c->check->run), section);
    if (section->found) {
        c->check->fair &= section->excess == 0;
        c->check->judged_count++;
    }
    batten_polylines_release(&lines);
    return status;
}

static batten_status add_sections(bat_check *check, bat_checked *checked)
{
    const int feature = checked->faired >= 0 ? checked->faired : checked->given;
    section_context context = {check, checked};
    if (feature < 0)
        return BATTEN_OK;
    batten_status status = visit_rows(check, feature, true, count_section, &context);
    checked->sections = bat_arena_array(&check->arena, (size_t)checked->section_count,
                                        sizeof *checked->sections);
    checked->section_count = 0;
    if (status == BATTEN_OK && !checked->sections)
        status = BATTEN_OUT_OF_MEMORY;
    return status == BATTEN_OK ? visit_rows(check, feature, true, add_section, &context)
                               : status;
}

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

static batten_status check_surface(bat_check *check, bat_checked *checked)
{
    batten_status status = add_distance(check, checked, checked->given);
    if (status == BATTEN_OK)
        status = add_distance(check, checked, checked->faired);
    if (status == BATTEN_OK)
        status = add_sections(check, checked);
    for (int i = 0; i < 4 && status == BATTEN_OK; i++)
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
    bat_data_distance *to = &checked->distances[checked->distance_count++];
    *to = (bat_data_distance){.feature = object->name,
                              .is_faired = checked->faired >= 0,
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

static batten_status check_curve(bat_check *check, bat_checked *checked)
{
    const batten_object *object = checked->object;
    const int axis =
        object->point_count ? bat_flat_axis(object->point_count, object->points) : -1;
    batten_curve *curve = NULL;
    double *data = bat_points_in_plane(axis, object->point_count, object->points);
    batten_status status =
        data ? bat_curve_in_plane(object->curve, axis, &curve) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_fairness(curve,
                                       (batten_points){batten_curve_dimension(curve),
                                                       object->point_count,
                                                       object->point_count ? data : NULL},
                                       &checked->fairness);
    checked->has_fairness = status == BATTEN_OK;
    if (checked->has_fairness && axis >= 0) {
        check->fair &= checked->fairness.excess_inflections == 0;
        check->judged_count++;
    }
    bat_release(data);
    batten_curve_unref(curve);
    if (status == BATTEN_OK)
        status = add_knots(check, checked);
    return status == BATTEN_OK && object->point_count ? add_curve_distance(check, checked)
                                                      : status;
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
                            bat_check *out)
{
    bat_objects objects = {0, NULL};
    *out = (bat_check){.run = run, .within = within, .ok = true, .fair = true};
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
        status = trace_objects(out, parameter);
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = check_object(out, &out->objects[i]);
    /* A bound that nothing could be measured against is not met. */
    out->ok &= out->bounded_count > 0 || !isfinite(within);
    if (status == BATTEN_OK)
        status = bat_joins_find(out);
    bat_objects_release(&objects);
    return status;
}

void bat_check_release(bat_check *check)
{
    bat_release(check->joins);
    bat_arena_free(&check->arena);
}
