/* The shaded picture of surfaces, bodies and meshes. */
#include "picture/shaded/shade.h"
#include "base/plural.h"
#include "numeric/box.h"

#include <stdlib.h>
#include <string.h>

/* ---- boxes ---- */

static int longest_axis(const batten_box *box)
{
    const double range[] = {box->high.x - box->low.x, box->high.y - box->low.y,
                            box->high.z - box->low.z};
    const int longer = range[1] > range[0] ? 1 : 0;
    return range[2] > range[longer] ? 2 : longer;
}

/* ---- from space to samples ---- */

typedef struct {
    const bat_view *view;
    double low[2], high[2];
} projection;

static void project_points(void *user, size_t count, double *points)
{
    projection *to = user;
    for (size_t i = 0; i < count; i++) {
        double q[3];
        bat_view_project(to->view, points + 3 * i, q);
        memcpy(points + 3 * i, q, sizeof q);
        for (int k = 0; k < 2; k++) {
            to->low[k] = bat_min(to->low[k], q[k]);
            to->high[k] = bat_max(to->high[k], q[k]);
        }
    }
}

static void move_points(void *user, size_t count, double *points)
{
    const bat_plot *plot = user;
    for (size_t i = 0; i < count; i++) {
        double *p = points + 3 * i;
        p[0] = BAT_SAMPLES * bat_plot_x(plot, p[0]);
        p[1] = BAT_SAMPLES * bat_plot_y(plot, p[1]);
        p[2] = BAT_SAMPLES * plot->scale * p[2];
    }
}

typedef void change_points(void *user, size_t count, double *points);

static void change_strokes(const bat_strokes *strokes, change_points *change, void *user)
{
    for (size_t i = 0; i < strokes->count; i++)
        change(user, strokes->strokes[i].count, strokes->strokes[i].points);
}

static void change_all(const bat_shaded *p, change_points *change, void *user)
{
    for (int i = 0; i < p->solid_count; i++) {
        const bat_tiles *t = &p->solids[i].tiles;
        change(user, t->count_u * t->count_v, t->points);
        change_strokes(&p->solids[i].edges, change, user);
        change_strokes(&p->solids[i].isolines, change, user);
    }
    for (int i = 0; i < p->mesh_count; i++) {
        change(user, (size_t)p->meshes[i].mesh->vertex_count, p->meshes[i].points);
        change_strokes(&p->meshes[i].lines, change, user);
    }
    change_strokes(&p->curves, change, user);
}

static batten_status fit_picture(bat_shaded *p)
{
    projection seen = {&p->view, {HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
    change_all(p, project_points, &seen);
    const double range[2] = {seen.high[0] - seen.low[0], seen.high[1] - seen.low[1]};
    bat_rectangle at = bat_shaded_stage(p);
    p->options->height = bat_size_height(p->options, at.width, range, bat_shaded_around(p));
    at = bat_shaded_stage(p);
    bat_plot plot = bat_plot_fit(at, seen.low, seen.high);
    if (!isfinite(plot.x0) || !isfinite(plot.y0) || !(plot.scale > 0))
        return bat_fail(BATTEN_OVERFLOW, "coordinates from %g to %g are too large to draw",
                        seen.low[0], seen.high[0]);
    change_all(p, move_points, &plot);
    return BATTEN_OK;
}

static batten_status make_picture(bat_shaded *p, char **data, size_t *size)
{
    const batten_draw_options *o = p->options;
    bat_canvas canvas;
    batten_status status =
        bat_canvas_begin(BATTEN_PICTURE_PNG, o->width, o->height, p->em, o->title, &canvas);
    if (status != BATTEN_OK)
        return status;
    status = bat_shaded_fill(p, &canvas);
    if (status == BATTEN_OK) {
        bat_shaded_write_around(&canvas, p);
        return bat_canvas_finish(&canvas, data, size);
    }
    bat_canvas_end(&canvas);
    return status;
}

/* ---- the whole ---- */

static batten_status check_options(const batten_draw_options *o)
{
    if (o->format != BATTEN_PICTURE_PNG)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "shaded pictures are PNG; SVG and PDF show lines only");
    if (o->isolines < 1 || o->isolines > 1000)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d isolines are asked for; from 1 to 1000 are drawn", o->isolines);
    if (!(o->stripes > 0 && o->stripes <= 1000))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%g zebra stripes are asked for; up to 1000 are drawn", o->stripes);
    if (!isfinite(o->azimuth) || !isfinite(o->elevation))
        return bat_fail(BATTEN_NOT_FINITE, "azimuth %g and elevation %g must be finite",
                        o->azimuth, o->elevation);
    return bat_size_check(o);
}

static batten_status prepare(bat_shaded *p)
{
    batten_box box = bat_box_of_nothing();
    const batten_draw_options *o = p->options;
    bat_shaded_count(p, &box);
    const double size = bat_box_diagonal(box);
    if (p->solid_count + p->mesh_count == 0)
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "of the %d object%s of the model none is a surface in space, a body or a "
            "mesh: there is nothing to shade",
            batten_model_count(p->model), bat_plural(batten_model_count(p->model)));
    if (!isfinite(size))
        return bat_fail(BATTEN_OVERFLOW, "coordinates up to %g are too large to draw",
                        box.high.x);
    p->em = bat_size_em(o);
    p->view = bat_view_make(o->view, o->azimuth, o->elevation);
    p->scene = bat_scene_make(o->shading, &p->view, longest_axis(&box), o->stripes);

    batten_status status = bat_shaded_gather(p, size);
    if (status == BATTEN_OK && bat_curvature_of_shading(o->shading) != BAT_CURVATURE_NONE)
        status = bat_shaded_choose_range(p, size);
    return status == BATTEN_OK ? fit_picture(p) : status;
}

static void free_shaded(bat_shaded *p)
{
    for (int i = 0; p->solids && i < p->solid_count; i++) {
        bat_tiles_free(&p->solids[i].tiles);
        bat_strokes_free(&p->solids[i].edges);
        bat_strokes_free(&p->solids[i].isolines);
    }
    for (int i = 0; p->meshes && i < p->mesh_count; i++)
        bat_mesh_solid_free(&p->meshes[i]);
    bat_release(p->solids);
    bat_release(p->meshes);
    bat_release(p->smooth);
    bat_strokes_free(&p->curves);
    bat_release(p->styles);
}

batten_status batten_draw_shaded(const batten_model *model, const batten_draw_options *options,
                                 const batten_job *job, char **data, size_t *size)
{
    batten_draw_options chosen = batten_draw_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_draw_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    bat_shaded p = {.options = &chosen, .job = job};
    batten_model *flat = NULL, *patches = NULL;
    status = check_options(&chosen);
    if (status == BATTEN_OK)
        status = bat_picture_model(model, &chosen, job, &flat);
    if (status == BATTEN_OK)
        status = batten_model_with_patches(flat, BATTEN_PATCHES_POLE, &patches);
    p.model = patches;
    if (status == BATTEN_OK)
        status = bat_smooth_edges(flat, patches, &p.smooth);
    if (status == BATTEN_OK)
        status = prepare(&p);
    if (status == BATTEN_OK)
        status = make_picture(&p, data, size);
    free_shaded(&p);
    batten_model_unref(patches);
    batten_model_unref(flat);
    return status;
}
