/* The feature 'box': the edges of boxes that just hold curves. */
#include "design/feature.h"

#include <batten/measure.h>
#include <batten/standard.h>
#include <stdio.h>

typedef enum { ALONG, TURNED } angle;

static const batten_parameter parameters[] = {
    {"box", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "the curves"},
    {"axes", BATTEN_VALUE_WORD, false, false, "world", "world turned",
     "along those of the world, or as the curve lies"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how close the polyline is from which turned boxes are found; the tolerance of the design by default"},
};

/* The corner on the sides that `signs` names. */
static void corner(const batten_oriented_box *box, const int *signs, double *out)
{
    out[0] = box->centre.x;
    out[1] = box->centre.y;
    out[2] = box->centre.z;
    for (int k = 0; k < 3; k++) {
        const double step = signs[k] * box->half[k];
        out[0] += step * box->axes[k].x;
        out[1] += step * box->axes[k].y;
        out[2] += step * box->axes[k].z;
    }
}

/* The rim of a face on one side of the third axis; or the edge between the two. */
static batten_status put_rim(bat_run *run, const batten_object *like,
                             const batten_oriented_box *box, int side)
{
    static const int around[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    double points[15];
    batten_curve *curve = NULL;
    for (int i = 0; i < 5; i++)
        corner(box, (const int[3]){around[i][0], around[i][1], side}, points + 3 * i);
    const batten_status status = batten_curve_polyline((batten_points){3, 5, points}, &curve);
    return bat_put_curve_like(run, status, curve, like, false);
}

static batten_status put_edge(bat_run *run, const batten_object *like,
                              const batten_oriented_box *box, int x, int y)
{
    double points[6];
    batten_curve *curve = NULL;
    corner(box, (const int[3]){x, y, -1}, points);
    corner(box, (const int[3]){x, y, 1}, points + 3);
    const batten_status status = batten_curve_polyline((batten_points){3, 2, points}, &curve);
    return bat_put_curve_like(run, status, curve, like, false);
}

static batten_status put_box(bat_run *run, const batten_object *object,
                             const batten_oriented_box *box)
{
    batten_object like = *object;
    char name[220];
    snprintf(name, sizeof name, "box of %.200s", object->name);
    like.name = name;
    /* Thinner than some thousand roundings of the box is flat. */
    const double flat = 1e-12 * (box->half[0] + box->half[1]);
    if (!(box->half[1] > flat))
        return bat_fail(BATTEN_COINCIDENT, "'%s' is straight: its box is a line", object->name);
    batten_status status = put_rim(run, &like, box, box->half[2] > flat ? -1 : 0);
    if (status == BATTEN_OK && box->half[2] > flat)
        status = put_rim(run, &like, box, 1);
    for (int i = 0; i < 4 && status == BATTEN_OK && box->half[2] > flat; i++)
        status = put_edge(run, &like, box, i % 2 ? 1 : -1, i / 2 ? 1 : -1);
    return status;
}

/* A box along the axes of the world, its thin side last. */
static batten_oriented_box of_world(const batten_box *b)
{
    const batten_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    const double half[3] = {(b->high.x - b->low.x) / 2, (b->high.y - b->low.y) / 2,
                            (b->high.z - b->low.z) / 2};
    const int thin = half[2] <= half[0] && half[2] <= half[1] ? 2 : half[1] <= half[0] ? 1 : 0;
    const batten_vec3 axes[3] = {x, y, z};
    batten_oriented_box box = {
        {b->low.x + half[0], b->low.y + half[1], b->low.z + half[2]}, {x, y, z}, {0}};
    for (int k = 0; k < 3; k++) {
        box.axes[k] = axes[(k + thin + 1) % 3];
        box.half[k] = half[(k + thin + 1) % 3];
    }
    return box;
}

static batten_status box_object(bat_run *run, const batten_object *object)
{
    batten_oriented_box oriented;
    batten_box box;
    const double within =
        bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    batten_status status;
    if (bat_word(run, "axes") == TURNED) {
        status = batten_curve_oriented_box(object->curve, within, &oriented);
    } else {
        status = batten_curve_bounds(object->curve, &box);
        if (status == BATTEN_OK)
            oriented = of_world(&box);
    }
    if (status != BATTEN_OK)
        return bat_fail(status, "%s: %s", object->name, batten_message());
    return put_box(run, object, &oriented);
}

static batten_status run_box(bat_run *run)
{
    return bat_for_objects(run, "box", BAT_CURVES, box_object);
}

const bat_feature bat_feature_box = {
    .shown =
        {"box", "The edges of boxes that just hold curves",
         "For the stock of a part, or the size of a sheet. Along the axes of the world the box is\n"
         "tight: its sides touch the curve. With 'axes: turned' it is aligned with the curve; in a\n"
         "plane across z no rectangle is smaller, within the tolerance, while in space the box is\n"
         "small but not proved to be the smallest. A flat box is one rectangle; a straight curve\n"
         "has no box.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 80 cm], [3 m, 2 m]]}\n"
         "  rib: {interpolate: ducks}\n"
         "  stock: {box: rib, axes: turned}\n",
         "[Toussaint83]", "batten_curve_oriented_box", BAT_PARAMETERS(parameters), false,
         .also = "bounding box, extent, oriented bounding box, stock"},
    .run = run_box};
