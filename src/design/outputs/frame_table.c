/* The output 'frame-table': a table (CSV): the frames along curves, for machines and
 * robots. */
#include "design/features/take/frames.h"
#include <batten/text.h>

static const batten_parameter parameters[] = {
    {"frame-table", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "the curves"},
    BAT_FRAMES_PARAMETERS,
};

static void add_vector(batten_text *out, batten_vec3 v)
{
    const double values[3] = {v.x, v.y, v.z};
    for (int k = 0; k < 3; k++) {
        batten_text_add(out, ",");
        batten_text_number(out, values[k]);
    }
}

/* One frame: the curve, its place, the origin, the three axes. */
static void add_row(batten_text *out, int curve, const bat_frames *all, int k)
{
    const batten_frame *f = &all->frames[k];
    const batten_vec3 y = {f->z.y * f->x.z - f->z.z * f->x.y, f->z.z * f->x.x - f->z.x * f->x.z,
                           f->z.x * f->x.y - f->z.y * f->x.x};
    batten_text_add(out, "%d,", curve);
    batten_text_number(out, all->at[k]);
    batten_text_add(out, ",");
    batten_text_number(out, all->length[k]);
    add_vector(out, f->origin);
    add_vector(out, f->x);
    add_vector(out, y);
    add_vector(out, f->z);
    batten_text_add(out, "\n");
}

static batten_status run_frame_table(bat_run *run)
{
    bat_objects objects;
    batten_text text = BATTEN_TEXT;
    batten_status status = bat_gather(run, "frame-table", BAT_CURVES, &objects);
    if (status != BATTEN_OK)
        return status;
    batten_text_add(&text, "curve,parameter,length,x,y,z,xx,xy,xz,yx,yy,yz,tx,ty,tz\n");
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++) {
        bat_frames all = {0};
        status = bat_frames_of(run, objects.at[i], &all);
        for (int k = 0; k < all.count; k++)
            add_row(&text, i + 1, &all, k);
        bat_frames_release(&all);
    }
    if (status == BATTEN_OK)
        status = batten_text_take(&text, &run->data, &run->size);
    batten_text_free(&text);
    bat_objects_release(&objects);
    return status;
}

const bat_feature bat_feature_frame_table = {
    .shown =
        {"frame-table", "A table (CSV): the frames along curves, for machines and robots",
         "A row for each frame: the number of the curve, parameter and arc length, the point, and\n"
         "the axes x, y and t (the tangent), with all digits. The frames are those of 'frames'.",
         "features:\n"
         "  ducks: {points: [[0, 0, 0], [1 m, 0, 0], [1 m, 1 m, 50 cm], [0, 1 m, 1 m]]}\n"
         "  pipe: {interpolate: ducks}\n"
         "outputs:\n"
         "  pipe.csv: {frame-table: pipe, count: 50}\n",
         "[WJZL08]", "batten_curve_frames", BAT_PARAMETERS(parameters), true,
         .also = "frames as table, robot path, CSV"},
    .run = run_frame_table};
