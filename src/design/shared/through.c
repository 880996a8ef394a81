/* What the methods "points to curve" share: a row in, a curve or a chain out. */
#include "design/shared/through.h"
#include "base/plural.h"

#include <string.h>

/* The plane in which a row lies, as the place of its two coordinates in space. */
typedef struct {
    int axis; /* the coordinate that is the same for all points; -1: the row is taken in space
               */
    batten_frame frame;
} row_plane;

/* What is asked of one row, and what lives while it is made. */
typedef struct {
    bat_run *run;
    const bat_method *method;
    const bat_row *row;
    row_plane plane;
    bat_data data;
    double *coordinates, *abscissae;
    bat_made made;
} task;

static bool as_function(const bat_run *run, unsigned ways)
{
    if (ways == BAT_AS_FUNCTION)
        return true;
    return (ways & BAT_AS_FUNCTION) && bat_word(run, "as") == 1;
}

/* ---- points in the form that the method wants ---- */

static batten_status find_plane(task *t)
{
    const int axis = bat_flat_axis(t->row->count, t->row->points);
    if (axis < 0)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the points must lie in a plane x, y or z = constant for '%s'",
                        t->run->feature->name);
    t->plane.axis = axis;
    t->plane.frame = batten_frame_across(axis, t->row->points[axis]);
    return BATTEN_OK;
}

static batten_status split_function(task *t)
{
    const int n = t->row->count;
    t->abscissae = bat_array((size_t)n, sizeof *t->abscissae);
    if (!t->abscissae)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n; i++) {
        t->abscissae[i] = t->coordinates[2 * i];
        t->coordinates[i] = t->coordinates[2 * i + 1];
        if (i > 0 && !(t->abscissae[i] > t->abscissae[i - 1]))
            return bat_fail(BATTEN_NOT_INCREASING,
                            "a function needs rising abscissae: point %d is at %g, point %d "
                            "before it at %g",
                            i + 1, t->abscissae[i], i - 1 + 1, t->abscissae[i - 1]);
    }
    return BATTEN_OK;
}

static batten_status prepare(task *t)
{
    const bool function = as_function(t->run, t->method->ways);
    const bool in_plane = function || !(t->method->ways & BAT_IN_SPACE);
    batten_status status = in_plane ? find_plane(t) : BATTEN_OK;
    if (status != BATTEN_OK)
        return status;
    const int n = t->row->count;
    t->coordinates = bat_points_in_plane(t->plane.axis, n, t->row->points);
    t->made.parameters = bat_array((size_t)n, sizeof *t->made.parameters);
    if (!t->coordinates || !t->made.parameters)
        return BATTEN_OUT_OF_MEMORY;
    if (function)
        status = split_function(t);
    t->data = (bat_data){
        t->row->name, function ? 1 : in_plane ? 2 : 3, n, t->coordinates, t->abscissae,
        t->plane.axis};
    t->made.has_parameters = true;
    return status;
}

/* ---- what was made, put back into space ---- */

/* The graph (u, f(u)) of a chain of one dimension. */
static batten_status graph_of_chain(const batten_chain *chain, batten_chain **out)
{
    const int n = batten_chain_span_count(chain);
    const double *breaks = batten_chain_breaks(chain);
    batten_span *spans = bat_array((size_t)n, sizeof *spans);
    if (!spans)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n; i++) {
        spans[i] = *batten_chain_span(chain, i);
        spans[i].start[1] = spans[i].start[0];
        spans[i].start[0] = breaks[i];
        spans[i].end[1] = spans[i].end[0];
        spans[i].end[0] = breaks[i + 1];
        for (int e = 0; e < 2; e++) {
            spans[i].bend[e][1] = spans[i].bend[e][0];
            spans[i].bend[e][0] = 0;
        }
    }
    const batten_status status =
        batten_chain_create(&(batten_chain_parts){2, n, spans, breaks, false}, HUGE_VAL, out);
    bat_release(spans);
    return status;
}

static batten_status place_chain(const task *t, batten_chain **chain)
{
    batten_chain *graph = NULL, *placed = NULL;
    batten_status status = BATTEN_OK;
    if (t->data.dimension == 1)
        status = graph_of_chain(*chain, &graph);
    if (status == BATTEN_OK && t->data.dimension < 3)
        status = batten_chain_place(graph ? graph : *chain, &t->plane.frame, &placed);
    batten_chain_unref(graph);
    if (status == BATTEN_OK && placed) {
        batten_chain_unref(*chain);
        *chain = placed;
    }
    return status;
}

static batten_affine map_of_frame(const batten_frame *frame)
{
    const batten_vec3 o = frame->origin, x = frame->x, z = frame->z;
    const batten_vec3 y = {z.y * x.z - z.z * x.y, z.z * x.x - z.x * x.z, z.x * x.y - z.y * x.x};
    return (batten_affine){{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}},
                           {o.x, o.y, o.z}};
}

/* The control points of a plane curve, or of the graph of a function, in space: [count][3]. The axes of its frame are
 * those of space. */
static double *place_points(const batten_curve *curve, const row_plane *plane)
{
    const int n = batten_curve_point_count(curve), d = batten_curve_dimension(curve);
    const int first = plane->axis == 0 ? 1 : 0, second = plane->axis == 2 ? 1 : 2;
    const double *from = batten_curve_points(curve);
    const double across[3] = {plane->frame.origin.x, plane->frame.origin.y,
                              plane->frame.origin.z};
    double *points = bat_array3((size_t)n, 3, sizeof *points);
    for (int i = 0; points && i < n; i++) {
        /* No zero has a sign, as after a product and a sum. */
        points[3 * i + first] = 0 + (d == 1 ? batten_curve_greville(curve, i) : from[2 * i]);
        points[3 * i + second] = 0 + from[d * i + d - 1];
        points[3 * i + plane->axis] = across[plane->axis];
    }
    return points;
}

/* Where the control points alone change: all but rational functions and what is periodic. */
static batten_status place_plainly(const task *t, const batten_curve *curve, batten_curve **out)
{
    double *points = place_points(curve, &t->plane);
    batten_status status = points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status =
            batten_curve_create((batten_points){3, batten_curve_point_count(curve), points},
                                batten_curve_degree(curve), batten_curve_weights(curve),
                                batten_curve_knots(curve), out);
    bat_release(points);
    return status;
}

static batten_status place_step_by_step(const task *t, const batten_curve *curve,
                                        batten_curve **out)
{
    batten_curve *graph = NULL, *lifted = NULL;
    batten_status status = BATTEN_OK;
    if (batten_curve_dimension(curve) == 1)
        status = batten_curve_from_function(curve, &graph);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(graph ? graph : curve, 3, &lifted);
    const batten_affine map = map_of_frame(&t->plane.frame);
    if (status == BATTEN_OK)
        status = batten_curve_transform(lifted, &map, out);
    batten_curve_unref(graph);
    batten_curve_unref(lifted);
    return status;
}

static batten_status place_curve(const task *t, batten_curve **curve)
{
    batten_curve *placed = NULL;
    const int d = batten_curve_dimension(*curve);
    if (t->data.dimension == 3)
        return BATTEN_OK;
    const bool is_plain =
        !batten_curve_is_periodic(*curve) && (d == 2 || !batten_curve_is_rational(*curve));
    const batten_status status =
        is_plain ? place_plainly(t, *curve, &placed) : place_step_by_step(t, *curve, &placed);
    if (status == BATTEN_OK) {
        batten_curve_unref(*curve);
        *curve = placed;
    }
    return status;
}

double bat_chain_error(const bat_run *run, const batten_object *object)
{
    return object->chain ? bat_tolerance(run) / 1000 : 0;
}

/* The curve of a chain is far nearer to it than anybody asks of the design. */
static batten_status place_made(task *t)
{
    bat_made *made = &t->made;
    if (!made->chain)
        return place_curve(t, &made->curve);
    double error = 0;
    batten_status status = place_chain(t, &made->chain);
    if (status == BATTEN_OK)
        status = batten_chain_to_curve(made->chain, bat_tolerance(t->run) / 1000, &error,
                                       &made->curve);
    if (status == BATTEN_OK && error > 0)
        bat_report_error(t->run, error, error);
    return status;
}

static batten_status put_made(task *t, const batten_object *from)
{
    bat_made *made = &t->made;
    const batten_object like = {
        .name = t->row->name,
        .layer = from->layer,
        .kind = BATTEN_OBJECT_CURVE,
        .curve = made->curve,
        .chain = made->chain,
        .point_count = made->is_elsewhere ? 0 : t->row->count,
        .points = made->is_elsewhere ? NULL : t->row->points,
        .parameters = made->has_parameters ? made->parameters : NULL,
        .points_are_vertices = made->from_polygon,
    };
    if (made->has_error)
        bat_report_error(t->run, made->error_max, made->error_rms);
    return batten_model_add(t->run->model, &like);
}

/* ---- the whole ---- */

static batten_status make_row(bat_run *run, const bat_method *method, const bat_row *row,
                              const batten_object *from)
{
    task t = {.run = run, .method = method, .row = row, .plane = {.axis = -1}};
    batten_status status = bat_points_check_size(row->count, row->points);
    if (status == BATTEN_OK) {
        bat_note_spacing(run, row->name, row->count, row->points);
        status = prepare(&t);
    }
    if (status == BATTEN_OK)
        status = method->make(run, &t.data, &t.made);
    if (status == BATTEN_OK)
        status = place_made(&t);
    if (status == BATTEN_OK)
        status = put_made(&t, from);
    batten_curve_unref(t.made.curve);
    batten_chain_unref(t.made.chain);
    bat_release(t.made.parameters);
    bat_release(t.coordinates);
    bat_release(t.abscissae);
    if (status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED)
        return status;
    return bat_fail(status, "%s: %s", row->name, batten_message());
}

static batten_status make_long_row(bat_run *run, const bat_method *method, const bat_row *row,
                                   const batten_object *object)
{
    if (row->count >= method->least)
        return make_row(run, method, row, object);
    bat_note(run, "'%s' has %d point%s and is left out; %d are needed", row->name, row->count,
             bat_plural(row->count), method->least);
    return BATTEN_OK;
}

static batten_status make_object(bat_run *run, const bat_method *method,
                                 const batten_object *object)
{
    enum { LINE = 1 };
    bat_rows rows = {0, NULL};
    batten_status status = bat_rows_of(object, bat_word(run, "each") == LINE, &rows);
    for (int i = 0; i < rows.count && status == BATTEN_OK; i++)
        status = make_long_row(run, method, &rows.rows[i], object);
    bat_rows_release(&rows);
    return status;
}

batten_status bat_through(bat_run *run, const bat_method *method)
{
    bat_objects objects;
    batten_status status =
        bat_gather(run, run->feature->parameters[0].name, BAT_POINTS | BAT_OFFSETS, &objects);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = make_object(run, method, objects.at[i]);
    if (status == BATTEN_OK && batten_model_count(run->model) == 0)
        status = bat_fail(BATTEN_TOO_FEW_POINTS, "no row has %d points", method->least);
    bat_objects_release(&objects);
    return status;
}

/* ---- what methods read ---- */

batten_status bat_indices(const bat_run *run, const char *parameter, int *count, int **out)
{
    const bat_argument *argument = bat_argument_of(run, parameter);
    int *made = bat_array((size_t)argument->count, sizeof *made);
    batten_status status = made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < argument->count; i++) {
        made[i] = argument->items[i].count - 1;
        if (made[i] < 0)
            status =
                bat_fail(BATTEN_BAD_ARGUMENT, "'%s' names point %d; points are counted from 1",
                         parameter, argument->items[i].count);
    }
    if (status != BATTEN_OK)
        bat_release(made);
    *count = status == BATTEN_OK ? argument->count : 0;
    *out = status == BATTEN_OK ? made : NULL;
    return status;
}

batten_status bat_numbers_each(const bat_run *run, const char *parameter, int count,
                               const char *things, double **out)
{
    const bat_argument *given = bat_argument_of(run, parameter);
    if (given->count != 1 && given->count != count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' has %d number%s for %d %s", parameter,
                        given->count, bat_plural(given->count), count, things);
    double *numbers = bat_array((size_t)count, sizeof *numbers);
    if (!numbers)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        numbers[i] = given->items[given->count == 1 ? 0 : i].number[0];
    *out = numbers;
    return BATTEN_OK;
}
