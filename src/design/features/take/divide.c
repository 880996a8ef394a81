/* The feature 'divide': points on curves: equal lengths, equal chords, chords that stay
 * near, ends of pieces. */
#include "design/features/take/pieces.h"
#include <batten/invariants.h>

#include <string.h>

typedef enum { LENGTH, AFFINE } measures;

static const batten_parameter parameters[] = {
    {"divide", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves"},
    {"count", BATTEN_VALUE_COUNT, false, false, NULL, NULL, "parts of equal length"},
    {"by", BATTEN_VALUE_WORD, false, false, "length", "length affine",
     "which length 'count' makes equal; affine: the one that affine maps do not change"},
    {"chords", BATTEN_VALUE_COUNT, false, false, NULL, NULL,
     "instead: parts with chords of equal length"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "instead: as many parts as needed to keep each chord this close to the curve"},
    {"angle", BATTEN_VALUE_ANGLE, false, false, NULL, NULL,
     "instead or as well: as many as needed for the curve to turn by no more than this along each"},
    BAT_PIECES_PARAMETERS,
};

/* The points at the parameters, in space, under the name of the curve. */
static batten_status put_points(bat_run *run, const batten_object *object,
                                const batten_parameters *at)
{
    const int d = batten_curve_dimension(object->curve);
    double *points = bat_array((size_t)at->count, 3 * sizeof *points);
    batten_status status = points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_many(object->curve, (size_t)at->count, at->at, 0,
                                            run->job, points);
    /* The last first: each moves to where no other stands any more. */
    for (int i = at->count - 1; i >= 0 && status == BATTEN_OK && d < 3; i--) {
        double p[3] = {0};
        memcpy(p, points + d * i, (size_t)d * sizeof *p);
        memcpy(points + 3 * i, p, sizeof p);
    }
    const batten_object made = {.name = object->name,
                                .layer = object->layer,
                                .kind = BATTEN_OBJECT_POINTS,
                                .point_count = at->count,
                                .points = points};
    if (status == BATTEN_OK)
        status = bat_add(run, &made);
    bat_release(points);
    return status;
}

/* Into parts of equal length, or with equal chords. */
static batten_status divide_evenly(const bat_run *run, const batten_curve *curve,
                                   batten_parameters *at)
{
    enum { MOST = 1000000 };
    const double within = bat_tolerance(run) / 1000;
    const bool chords = bat_has(run, "chords");
    const int count = bat_count(run, chords ? "chords" : "count");
    if (count < 1 || count > MOST)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve is not cut into %d parts", count);
    at->count = count + 1;
    at->at = bat_array((size_t)count + 1, sizeof *at->at);
    if (!at->at)
        return BATTEN_OUT_OF_MEMORY;
    if (chords)
        return batten_curve_divide_equal_chords(curve, count, within, NULL, at->at);
    return bat_word(run, "by") == AFFINE
               /* Relative to the whole affine length. */
               ? batten_curve_divide_affine(curve, count, 1e-9, at->at)
               : batten_curve_divide(curve, count, within, at->at);
}

static batten_status divide_object(bat_run *run, const batten_object *object)
{
    batten_parameters at = {0, NULL};
    batten_status status;
    const double height = bat_has(run, "within") ? bat_number(run, "within") : HUGE_VAL;
    if (bat_has(run, "pieces"))
        status = bat_pieces_divide(run, object, &at);
    else if (bat_has(run, "angle"))
        status = batten_curve_divide_turn(object->curve, height, bat_number(run, "angle"), &at);
    else if (bat_has(run, "within"))
        status = batten_curve_divide_chord(object->curve, height, &at);
    else
        status = divide_evenly(run, object->curve, &at);
    if (status == BATTEN_OK)
        status = put_points(run, object, &at);
    bat_release(at.at);
    return status;
}

static batten_status run_divide(bat_run *run)
{
    const bool near = bat_has(run, "within") || bat_has(run, "angle");
    if (bat_has(run, "count") + bat_has(run, "chords") + near + bat_has(run, "pieces") != 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "one of 'count', 'chords', 'within' (or 'angle') "
                                             "and 'pieces' must be given");
    return bat_for_objects(run, "divide", BAT_CURVES, divide_object);
}

const bat_feature bat_feature_divide = {
    .shown =
        {"divide",
         "Points on curves: equal lengths, equal chords, chords that stay near, ends of pieces",
         "With 'count' the points cut each curve into parts of equal length; with 'chords' the\n"
         "straight lines between them are equally long, as compasses step them off. Both ends are\n"
         "points. 'by: affine' takes affine arc length for 'count', so that the points of a curve\n"
         "and of its image under any affine map correspond; they are dense where the curve bends,\n"
         "and a straight line is refused. With 'within' the polyline through them is proved to\n"
         "stay that close to the curve; it has a point at each knot, and at most a few times as\n"
         "many points as are needed. A curve that turns back close to itself may have no equal\n"
         "chords, which is an error. With 'angle' the tangents along each part are within that\n"
         "angle of each other. With 'pieces' the points are where pieces of that kind start and\n"
         "end, as 'split' would cut them.",
         "features:\n"
         "  rim: {circle: 1 m}\n"
         "  bolts: {divide: rim, count: 12}\n"
         "  sides: {divide: rim, chords: 7}\n",
         "[PT97] [Blaschke23]", "batten_curve_divide", BAT_PARAMETERS(parameters), false,
         .also =
             "equal parts, equal chords, subdivide, points along, array along curve, dividers"},
    .run = run_divide};
