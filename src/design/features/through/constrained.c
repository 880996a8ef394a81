/* The feature 'constrained': a curve through points that obeys inequalities. */
#include "design/shared/local.h"
#include <batten/interpolate.h>

#include <string.h>

static const batten_parameter parameters[] = {
    {"constrained", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "rows of points, a table of offsets, or curves that have points"},
    BAT_EACH,
    BAT_AS,
    {"lines", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "points of lines or planes on one side of which the curve stays"},
    {"sides", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "one for each of these: at right angles to it, towards the side of the curve"},
    {"from", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "one for each of these: the point from which it applies, counted from 1"},
    {"to", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "one for each of these: the point up to which it applies; 0: the last"},
    {"forward", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "directions in which the curve never goes back"},
    {"bent", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "directions towards which the second derivative points everywhere"},
    {"at", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "points with a given direction, counted from 1"},
    {"directions", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "one for each of these; their lengths do not matter"},
    {"speed", BATTEN_VALUE_NUMBER, false, false, "0.5", NULL,
     "the least speed with which a curve passes there, relative to its mean speed; 0: it may stand still"},
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL, "of the curve, 1 to 25"},
    {"pieces", BATTEN_VALUE_COUNT, false, false, "4", NULL,
     "spans between neighbouring points; 0: one Bezier curve"},
    {"minimise", BATTEN_VALUE_WORD, false, false, "bending", "stretching bending variation",
     "the squared derivative that is least: the first, the second, the third"},
    {"checks", BATTEN_VALUE_COUNT, false, false, "4", NULL,
     "parts of each span on which inequalities are imposed, 1 to 64"},
    BAT_PARAMETRIZATION,
};

/* ---- constraints from lists of vectors ---- */

typedef struct {
    const bat_run *run;
    const bat_data *data;
    batten_constraint *list;
    int count;
} gathering;

/* A list of vectors in the plane of the data, or in space. */
static batten_status vectors_of(const gathering *g, const char *name, int *count, double **out)
{
    const bat_argument *given = bat_argument_of(g->run, name);
    double *rows = bat_array3((size_t)given->count, 3, sizeof *rows);
    *count = given->count;
    if (!rows)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < given->count; i++)
        memcpy(rows + 3 * i, given->items[i].number, 3 * sizeof *rows);
    *out = bat_points_in_plane(g->data->axis, given->count, rows);
    bat_release(rows);
    return *out ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status need_as_many(const char *one, int count, const char *other, int others)
{
    return count == others ? BATTEN_OK
                           : bat_fail(BATTEN_NOT_COMPATIBLE, "'%s' has %d and '%s' %d", one,
                                      count, other, others);
}

/* normal . P of a curve; of a function with the graph (u, f) only the part of f is unknown. */
static batten_constraint along(const gathering *g, batten_constraint_kind kind,
                               const double *normal)
{
    const bool function = g->data->dimension == 1;
    batten_constraint c = {.kind = kind};
    for (int k = 0; k < g->data->dimension; k++)
        c.normal[k] = normal[function ? 1 : k];
    if (function && kind == BATTEN_CONSTRAINT_VALUE)
        c.rate = -normal[0];
    if (function && kind == BATTEN_CONSTRAINT_SLOPE)
        c.bound = -normal[0];
    if (function && kind == BATTEN_CONSTRAINT_DIRECTION)
        c.normal[0] = normal[1] / normal[0];
    else if (kind == BATTEN_CONSTRAINT_DIRECTION)
        c.bound = bat_number(g->run, "speed");
    return c;
}

/* The points that 'from' and 'to' name, as indices; of 'to' 0 is the last point, in both. */
static batten_status limits_of(const gathering *g, int **first, int **last)
{
    const bat_argument *to = bat_argument_of(g->run, "to");
    int count = 0;
    batten_status status = bat_indices(g->run, "from", &count, first);
    if (status == BATTEN_OK && !(*last = bat_array((size_t)to->count, sizeof **last)))
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < to->count; i++) {
        const int point = to->items[i].count;
        (*last)[i] = point > 1 ? point - 1 : 0;
        if (point < 0 || point == 1)
            status = bat_fail(
                BATTEN_BAD_ARGUMENT,
                "'to' names point %d; it takes points after the first, or 0 for the last",
                point);
    }
    return status;
}

static batten_status gather_lines(gathering *g)
{
    const int d = g->data->dimension == 3 ? 3 : 2;
    const bat_argument *from = bat_argument_of(g->run, "from"),
                       *to = bat_argument_of(g->run, "to");
    double *lines = NULL, *sides = NULL;
    int line_count = 0, side_count = 0, *first = NULL, *last = NULL;
    batten_status status = vectors_of(g, "lines", &line_count, &lines);
    if (status == BATTEN_OK)
        status = vectors_of(g, "sides", &side_count, &sides);
    if (status == BATTEN_OK)
        status = need_as_many("lines", line_count, "sides", side_count);
    if (status == BATTEN_OK && from->count > 0)
        status = need_as_many("lines", line_count, "from", from->count);
    if (status == BATTEN_OK && to->count > 0)
        status = need_as_many("lines", line_count, "to", to->count);
    if (status == BATTEN_OK)
        status = limits_of(g, &first, &last);
    for (int i = 0; i < line_count && status == BATTEN_OK; i++) {
        batten_constraint *c = &g->list[g->count++];
        *c = along(g, BATTEN_CONSTRAINT_VALUE, sides + i * d);
        for (int k = 0; k < d; k++)
            c->bound += sides[i * d + k] * lines[i * d + k];
        c->from = from->count > 0 ? first[i] : 0;
        c->to = to->count > 0 ? last[i] : 0;
    }
    bat_release(first);
    bat_release(last);
    bat_release(lines);
    bat_release(sides);
    return status;
}

static batten_status gather_whole(gathering *g, const char *list, batten_constraint_kind kind)
{
    const int d = g->data->dimension == 3 ? 3 : 2;
    double *vectors = NULL;
    int count = 0;
    const batten_status status = vectors_of(g, list, &count, &vectors);
    for (int i = 0; i < count && status == BATTEN_OK; i++)
        g->list[g->count++] = along(g, kind, vectors + i * d);
    bat_release(vectors);
    return status;
}

static batten_status gather_directions(gathering *g)
{
    const int before = g->count;
    const bat_argument *at = bat_argument_of(g->run, "at");
    batten_status status = gather_whole(g, "directions", BATTEN_CONSTRAINT_DIRECTION);
    int count = 0, *points = NULL;
    if (status == BATTEN_OK)
        status = need_as_many("at", at->count, "directions", g->count - before);
    if (status == BATTEN_OK)
        status = bat_indices(g->run, "at", &count, &points);
    for (int i = before; i < g->count && status == BATTEN_OK; i++) {
        g->list[i].from = points[i - before];
        if (!isfinite(g->list[i].normal[0]))
            status = bat_fail(BATTEN_BAD_ARGUMENT,
                              "direction %d is upright, which that of a function cannot be",
                              i - before + 1);
    }
    bat_release(points);
    return status;
}

static batten_status gather(gathering *g)
{
    static const char *const lists[] = {"lines", "forward", "bent", "directions"};
    size_t most = 0;
    for (int i = 0; i < 4; i++)
        most += (size_t)bat_argument_of(g->run, lists[i])->count;
    g->list = bat_array(most, sizeof *g->list);
    if (!g->list)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = gather_lines(g);
    if (status == BATTEN_OK)
        status = gather_whole(g, "forward", BATTEN_CONSTRAINT_SLOPE);
    if (status == BATTEN_OK)
        status = gather_whole(g, "bent", BATTEN_CONSTRAINT_BEND);
    if (status == BATTEN_OK)
        status = gather_directions(g);
    return status;
}

/* ---- the feature ---- */

static batten_status make_constrained(bat_run *run, const bat_data *data, bat_made *made)
{
    gathering g = {run, data, NULL, 0};
    batten_curve_constrained_options options = batten_curve_constrained_defaults();
    batten_status status = gather(&g);
    options.degree = bat_count(run, "degree");
    options.pieces = bat_count(run, "pieces");
    options.order = 1 + (int)bat_word(run, "minimise");
    options.checks = bat_count(run, "checks");
    options.parameters = bat_parametrization_of(run, data);
    options.given = data->abscissae;
    options.constraint_count = g.count;
    options.constraints = g.list;
    if (status == BATTEN_OK)
        status = batten_curve_constrained(
            (batten_points){data->dimension, data->count, data->points}, &options,
            made->parameters, NULL, &made->curve);
    bat_release(g.list);
    return status;
}

static batten_status run_constrained(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE | BAT_AS_FUNCTION, make_constrained};
    return bat_through(run, &method);
}

const bat_feature bat_feature_constrained = {
    .shown =
        {"constrained", "A curve through points that obeys inequalities",
         "For places where an ordinary spline would cross a keel line, leave a band of clearance,\n"
         "swing back or bulge: among all curves through the points that obey the inequalities this\n"
         "is the one with the least integral of a squared derivative. A line or plane is given by\n"
         "a point in 'lines' and the side by a vector in 'sides'; two of them make a band; 'from'\n"
         "and 'to' limit one to the part between two points. The curve never goes back in the\n"
         "directions of 'forward' (a function rises with [0, 1], falls with [0, -1]), and is bent\n"
         "towards those of 'bent' (a function is convex with [0, 1]). The inequalities hold\n"
         "everywhere, not only at samples. 'pieces: 0' with a degree of 5 to 9 is one Bezier curve\n"
         "with given tangents. Constraints that contradict the points or each other are named. It\n"
         "suits some dozens of points: the cost grows with the cube of their number.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1, 0], [2, 0.05], [3, 1], [4, 1.05], [5, 1.1]]}\n"
         "  ramp: {constrained: ducks, lines: [[0, 0]], sides: [[0, 1]], forward: [[0, 1]]}\n",
         "[Utah74 paper 8] [Wielinga74] [GI83]", "batten_curve_constrained",
         BAT_PARAMETERS(parameters), false,
         .also =
             "Wielinga, constrained interpolation, convex spline, monotone spline, one-sided, obstacle",
         .formula =
             "    S(t_i) = P_i;  n·(S − a) ≥ 0 beside a line,  f·S′ ≥ 0 forward,  b·S″ ≥ 0 bent, for all t",
         .promise =
             "∫ |S^(r)|² dt is least of all splines of its degree and knots that obey the conditions; r = 1, 2, 3 is stretching, bending, variation."},
    .run = run_constrained};
