/* The feature 'conic': an arc of an ellipse, parabola or hyperbola, exactly. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"conic", BATTEN_VALUE_POINT, true, true, NULL, NULL,
     "start, where the end tangents meet, end; or five points on it, in order"},
    {"weight", BATTEN_VALUE_NUMBER, false, false, "1", NULL,
     "below 1 an ellipse, 1 a parabola, above 1 a hyperbola"},
    {"through", BATTEN_VALUE_POINT, false, false, NULL, NULL,
     "a further point of the xy-plane, instead of the weight"},
};

static batten_status through_five(bat_run *run, const bat_item *items)
{
    double points[10];
    batten_curve *conic = NULL, *lifted = NULL;
    for (int i = 0; i < 10; i++)
        points[i] = items[i / 2].number[i % 2];
    batten_status status = batten_curve_conic_five((batten_points){2, 5, points}, &conic);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(conic, 3, &lifted);
    batten_curve_unref(conic);
    return bat_put_curve(run, status, lifted);
}

static batten_status through_one(bat_run *run, const bat_item *items)
{
    const batten_vec3 q = bat_point(run, "through");
    batten_curve *conic = NULL, *lifted = NULL;
    batten_status status = batten_curve_conic_through(
        (batten_vec2){items[0].number[0], items[0].number[1]},
        (batten_vec2){items[1].number[0], items[1].number[1]},
        (batten_vec2){items[2].number[0], items[2].number[1]}, (batten_vec2){q.x, q.y}, &conic);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(conic, 3, &lifted);
    batten_curve_unref(conic);
    return bat_put_curve(run, status, lifted);
}

static bool is_flat(const bat_run *run, const bat_argument *points)
{
    bool flat = bat_point(run, "through").z == 0;
    for (int i = 0; i < points->count; i++)
        flat &= points->items[i].number[2] == 0;
    return flat;
}

static batten_status run_conic(bat_run *run)
{
    const bat_argument *points = bat_argument_of(run, "conic");
    const bat_item *items = points->items;
    if (points->count != 3 && points->count != 5)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a conic is given by 3 or 5 points, not %d",
                        points->count);
    if ((points->count == 5 || bat_has(run, "through")) && !is_flat(run, points))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a conic through points is drawn in the plane z = 0");
    if (points->count == 5)
        return through_five(run, items);
    if (bat_has(run, "through"))
        return through_one(run, items);
    batten_curve *conic = NULL;
    const batten_status status =
        batten_curve_conic(3, items[0].number, items[1].number, items[2].number,
                           bat_number(run, "weight"), &conic);
    return bat_put_curve(run, status, conic);
}

const bat_feature bat_feature_conic = {
    .shown =
        {"conic", "An arc of an ellipse, parabola or hyperbola, exactly",
         "From three points: the ends, and between them the point where the tangents at the ends\n"
         "meet; a weight or a further point decides which conic it is. From five points: the conic\n"
         "through them.",
         "features:\n"
         "  stem: {conic: [[0, 0], [1 m, 0], [1.4 m, 1 m]], weight: 0.8}\n",
         "[PT97 section 7.3]", "batten_curve_conic", BAT_PARAMETERS(parameters), false,
         .also = "parabola, hyperbola, ellipse arc, rho, shoulder point, five points",
         .formula =
             "    C(t) = (B0 P0 + w B1 P1 + B2 P2)/(B0 + w B1 + B2);  w < 1 ellipse, w = 1 parabola, w > 1 hyperbola",
         .promise = "It is exact."},
    .run = run_conic};
