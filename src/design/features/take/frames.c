/* The feature 'frames': frames along curves, as crosses or as a ribbon. */
#include "design/features/take/frames.h"
#include "base/plural.h"

#include <batten/interpolate.h>
#include <batten/measure.h>
#include <batten/standard.h>
#include <stdio.h>

typedef enum { CROSSES, RIBBON } form;

static const batten_parameter parameters[] = {
    {"frames", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "the curves"},
    BAT_FRAMES_PARAMETERS,
    {"as", BATTEN_VALUE_WORD, false, false, "crosses", "crosses ribbon",
     "a polyline along the curve and the axes; or a surface along x"},
    {"size", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "length of the lines, width of the ribbon; a twentieth of the curve by default"},
};

void bat_frames_release(bat_frames *frames)
{
    bat_release(frames->frames);
    bat_release(frames->length);
    bat_release(frames->at);
    *frames = (bat_frames){0};
}

batten_status bat_frames_of(const bat_run *run, const batten_object *object, bat_frames *out)
{
    const batten_curve *curve = object->curve;
    const int count = bat_count(run, "count");
    if (count < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d frame%s asked for; at least 2 are needed",
                        count, bat_one_or_many(count, " is", "s are"));
    const size_t n = (size_t)count;
    const double tolerance = bat_tolerance(run) / 1000;
    double length = 0;
    bat_frames made = {count, bat_array(n, sizeof *made.at), bat_array(n, sizeof *made.length),
                       bat_array(n, sizeof *made.frames)};
    batten_status status =
        made.at && made.length && made.frames ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_divide(curve, count - 1, tolerance, made.at);
    if (status == BATTEN_OK)
        status = batten_curve_length(curve, tolerance, NULL, &length);
    if (status == BATTEN_OK)
        status = batten_curve_frames(curve, count, made.at,
                                     (batten_frame_kind)bat_word(run, "kind"), made.frames);
    for (int k = 0; k < count && status == BATTEN_OK; k++)
        made.length[k] = length * k / (count - 1);
    if (status == BATTEN_OK) {
        *out = made;
        return BATTEN_OK;
    }
    bat_frames_release(&made);
    return status == BATTEN_OUT_OF_MEMORY
               ? status
               : bat_fail(status, "%s: %s", object->name, batten_message());
}

/* ---- drawing ---- */

static void step_along(batten_vec3 from, double step, batten_vec3 along, double *to)
{
    to[0] = from.x + step * along.x;
    to[1] = from.y + step * along.y;
    to[2] = from.z + step * along.z;
}

static batten_vec3 second_axis(const batten_frame *f)
{
    return (batten_vec3){f->z.y * f->x.z - f->z.z * f->x.y, f->z.z * f->x.x - f->z.x * f->x.z,
                         f->z.x * f->x.y - f->z.y * f->x.x};
}

/* Along the curve, and at each frame out and back along x, and half as far along y. */
static batten_status put_crosses(bat_run *run, const batten_object *like, const bat_frames *all,
                                 double size)
{
    enum { STOPS = 5 };
    double *points = bat_array3((size_t)all->count, STOPS * 3, sizeof *points);
    batten_curve *crosses = NULL;
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < all->count; k++) {
        const batten_frame *f = &all->frames[k];
        double *stop = points + (size_t)k * STOPS * 3;
        step_along(f->origin, 0, f->x, stop);
        step_along(f->origin, size, f->x, stop + 3);
        step_along(f->origin, 0, f->x, stop + 6);
        step_along(f->origin, size / 2, second_axis(f), stop + 9);
        step_along(f->origin, 0, f->x, stop + 12);
    }
    const batten_status status =
        batten_curve_polyline((batten_points){3, all->count * STOPS, points}, &crosses);
    bat_release(points);
    return bat_put_curve_like(run, status, crosses, like, false);
}

static batten_status make_rail(const bat_frames *all, double side, batten_curve **out)
{
    double *points = bat_array3((size_t)all->count, 3, sizeof *points);
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = all->at;
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < all->count; k++)
        step_along(all->frames[k].origin, side, all->frames[k].x, points + 3 * k);
    const batten_status status =
        batten_curve_interpolate((batten_points){3, all->count, points}, &options, NULL, out);
    bat_release(points);
    return status;
}

/* Straight across, between two rails. */
static batten_status put_ribbon(bat_run *run, const batten_object *like, const bat_frames *all,
                                double size)
{
    batten_curve *left = NULL, *right = NULL;
    batten_surface *ribbon = NULL;
    batten_object of_surface = *like;
    of_surface.kind = BATTEN_OBJECT_SURFACE;
    of_surface.curve = NULL;
    of_surface.chain = NULL;
    batten_status status = make_rail(all, -size / 2, &left);
    if (status == BATTEN_OK)
        status = make_rail(all, size / 2, &right);
    if (status == BATTEN_OK)
        status = batten_surface_ruled(left, right, &ribbon);
    batten_curve_unref(right);
    batten_curve_unref(left);
    return bat_put_surface_like(run, status, ribbon, &of_surface);
}

static batten_status frame_object(bat_run *run, const batten_object *object)
{
    bat_frames all = {0};
    batten_status status = bat_frames_of(run, object, &all);
    if (status != BATTEN_OK)
        return status;
    const double size =
        bat_has(run, "size") ? bat_number(run, "size") : all.length[all.count - 1] / 20;
    batten_object like = *object;
    char name[220];
    snprintf(name, sizeof name, "frames of %.200s", object->name);
    like.name = name;
    if (!(size > 0))
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the size of frames is %g, not above 0", size);
    else if (bat_word(run, "as") == RIBBON)
        status = put_ribbon(run, &like, &all, size);
    else
        status = put_crosses(run, &like, &all, size);
    bat_frames_release(&all);
    return status;
}

static batten_status run_frames(bat_run *run)
{
    return bat_for_objects(run, "frames", BAT_CURVES, frame_object);
}

const bat_feature bat_feature_frames = {
    .shown =
        {"frames", "Frames along curves, as crosses or as a ribbon",
         "Each frame stands across the tangent. 'rotation-minimising' ones turn about it as little\n"
         "as possible, by double reflections, with an error of fourth order in their steps;\n"
         "'frenet' ones point to where the curve bends and are refused where it is straight;\n"
         "'fixed' ones keep their axes. Around a closed curve the minimising frame does not return\n"
         "to itself: 'closing' turns it back evenly by arc length. A cross has x, and y half as\n"
         "long; 'frame-table' writes the numbers.",
         "features:\n"
         "  ducks: {points: [[0, 0, 0], [1 m, 0, 0], [1 m, 1 m, 50 cm], [0, 1 m, 1 m]]}\n"
         "  pipe: {interpolate: ducks}\n"
         "  strip: {frames: pipe, as: ribbon, size: 10 cm}\n",
         "[WJZL08]", "batten_curve_frames", BAT_PARAMETERS(parameters), false,
         .also =
             "Frenet, rotation-minimising frame, RMF, Bishop frame, double reflection, parallel transport"},
    .run = run_frames,
    .displacing = "frames"};
