/* The views of a picture of lines on surfaces, and where they stand on the sheet. */
#include "picture/lines/surface_looks.h"
#include "picture/lines/wires.h"

/* ---- views ---- */

static bat_look look_from(const bat_looks_drawing *d, batten_view kind, double azimuth,
                          const char *title)
{
    const batten_vec3 a = d->wires.box.low, b = d->wires.box.high;
    const batten_view seen = kind == BATTEN_VIEW_AUTO ? BATTEN_VIEW_AXONOMETRIC : kind;
    return (bat_look){.kind = seen,
                      .eye = {bat_view_make(seen, azimuth, d->options->elevation),
                              {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z)},
                              d->options->distance},
                      .title = title};
}

void bat_looks_choose(bat_looks_drawing *d)
{
    const batten_draw_options *o = d->options;
    const double half = 0.5 * o->stereo_angle;
    const bool crossed = o->sheet == BATTEN_SHEET_STEREO_CROSSED;
    switch (o->sheet) {
    case BATTEN_SHEET_ONE:
        d->looks[d->look_count++] = look_from(d, o->view, o->azimuth, "");
        break;
    case BATTEN_SHEET_THREE_VIEWS:
        d->looks[d->look_count++] = look_from(d, BATTEN_VIEW_SIDE, 0, "side");
        d->looks[d->look_count++] = look_from(d, BATTEN_VIEW_FRONT, 0, "front");
        d->looks[d->look_count++] = look_from(d, BATTEN_VIEW_TOP, 0, "top");
        d->looks[d->look_count++] =
            look_from(d, o->view == BATTEN_VIEW_ISOMETRIC ? o->view : BATTEN_VIEW_AXONOMETRIC,
                      o->azimuth, "axonometric");
        break;
    case BATTEN_SHEET_STEREO_PARALLEL:
    case BATTEN_SHEET_STEREO_CROSSED:
        /* The left eye stands to the left: at the smaller azimuth. */
        d->looks[d->look_count++] =
            look_from(d, BATTEN_VIEW_AXONOMETRIC, o->azimuth + (crossed ? half : -half), "");
        d->looks[d->look_count++] =
            look_from(d, BATTEN_VIEW_AXONOMETRIC, o->azimuth + (crossed ? -half : half), "");
        break;
    }
}

batten_status bat_look_measure(const bat_looks_drawing *d, bat_look *l)
{
    const batten_vec3 a = d->wires.box.low, b = d->wires.box.high;
    for (int k = 0; k < 2; k++) {
        l->low[k] = HUGE_VAL;
        l->high[k] = -HUGE_VAL;
    }
    for (int i = 0; i < 8; i++) {
        const double corner[3] = {i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z};
        double q[3];
        const bat_eye parallel = {
            l->eye.view, {l->eye.centre[0], l->eye.centre[1], l->eye.centre[2]}, 0};
        bat_eye_project(&parallel, corner, q);
        if (l->eye.distance > 0 && q[2] > 0.95 * l->eye.distance)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "the eye is %g before the middle of what is drawn; its box reaches "
                            "%g towards it",
                            l->eye.distance, q[2]);
        bat_eye_project(&l->eye, corner, q);
        for (int k = 0; k < 2; k++) {
            l->low[k] = bat_min(l->low[k], q[k]);
            l->high[k] = bat_max(l->high[k], q[k]);
        }
    }
    return BATTEN_OK;
}

void bat_looks_measure_lines(const bat_looks_drawing *d, bat_look *l)
{
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < d->wires.count; i++) {
        const bat_stroke *s = &d->wires.wires[i].stroke;
        for (size_t k = 0; k < s->count; k++) {
            double q[3];
            bat_eye_project(&l->eye, s->points + 3 * k, q);
            for (int n = 0; n < 2; n++) {
                low[n] = bat_min(low[n], q[n]);
                high[n] = bat_max(high[n], q[n]);
            }
        }
    }
    for (int n = 0; n < 2 && low[n] <= high[n]; n++) {
        const double margin = 0.02 * bat_max(high[0] - low[0], high[1] - low[1]);
        l->low[n] = low[n] - margin;
        l->high[n] = high[n] + margin;
    }
}

/* ---- places on the sheet ---- */

/* Side and front in the first row, top and the axonometric view in the second; the first three
 * at one scale, so that every point stands in line. */
static void place_three(bat_looks_drawing *d, bat_rectangle all)
{
    const double gap = 3 * d->em, *sl = d->looks[0].low, *sh = d->looks[0].high;
    const double *fl = d->looks[1].low, *fh = d->looks[1].high, *tl = d->looks[2].low,
                 *th = d->looks[2].high;
    const double x = bat_max(sh[0] - sl[0], th[0] - tl[0]), y = fh[0] - fl[0];
    const double z = bat_max(sh[1] - sl[1], fh[1] - fl[1]), deep = th[1] - tl[1];
    const double scale = bat_min((all.width - gap) / (x + y), (all.height - gap) / (z + deep));
    const double wide = scale * x, tall = scale * z;
    const bat_rectangle frames[4] = {{all.x, all.y, wide, tall},
                                     {all.x + wide + gap, all.y, all.width - wide - gap, tall},
                                     {all.x, all.y + tall + gap, wide, all.height - tall - gap},
                                     {all.x + wide + gap, all.y + tall + gap,
                                      all.width - wide - gap, all.height - tall - gap}};
    for (int i = 0; i < 4; i++)
        d->looks[i].plot = bat_plot_fit(frames[i], d->looks[i].low, d->looks[i].high);
    for (int i = 0; i < 3; i++) { /* at the common scale, in the middle of their frames */
        bat_plot *p = &d->looks[i].plot;
        p->scale = scale;
        p->x0 = 0.5 * (d->looks[i].low[0] + d->looks[i].high[0]) - 0.5 * p->frame.width / scale;
        p->y0 =
            0.5 * (d->looks[i].low[1] + d->looks[i].high[1]) - 0.5 * p->frame.height / scale;
    }
}

static void place_looks(bat_looks_drawing *d, bat_rectangle all)
{
    if (d->look_count == 4) {
        place_three(d, all);
        return;
    }
    const double gap = d->look_count > 1 ? 2 * d->em : 0;
    const double wide = (all.width - gap) / d->look_count;
    for (int i = 0; i < d->look_count; i++)
        d->looks[i].plot =
            bat_plot_fit((bat_rectangle){all.x + i * (wide + gap), all.y, wide, all.height},
                         d->looks[i].low, d->looks[i].high);
}

static double above(const bat_looks_drawing *d)
{
    const double views = d->look_count == BAT_MOST_VIEWS ? 1 : 0; /* their names */
    return (*d->options->title ? 3.5 + views : 1.5 + views) * d->em;
}

/* What title and legend take of the height. */
static double around(const bat_looks_drawing *d)
{
    return above(d) + (d->options->contours ? 3.5 * d->em : 1.5 * d->em);
}

/* The size of all looks side by side, model units, without the gaps between them. */
static void range_of_all(const bat_looks_drawing *d, double range[2])
{
    const bat_look *l = d->looks;
    const double first[2] = {l[0].high[0] - l[0].low[0], l[0].high[1] - l[0].low[1]};
    range[0] = d->look_count * first[0];
    range[1] = first[1];
    for (int i = 1; d->look_count < 4 && i < d->look_count; i++)
        range[1] = bat_max(range[1], l[i].high[1] - l[i].low[1]);
    if (d->look_count < 4)
        return;
    range[0] = bat_max(first[0], l[2].high[0] - l[2].low[0]) + l[1].high[0] - l[1].low[0];
    range[1] = bat_max(first[1], l[1].high[1] - l[1].low[1]) + l[2].high[1] - l[2].low[1];
}

void bat_looks_place(bat_looks_drawing *d)
{
    const batten_draw_options *o = d->options;
    const double em = d->em, wide = bat_max(o->width - 4 * em, 8);
    const double gap = d->look_count == 1 ? 0 : d->look_count == 4 ? 3 * em : 2 * em;
    double range[2];
    range_of_all(d, range);
    const int height =
        bat_size_height(o, wide - gap, range, around(d) + (d->look_count == 4 ? gap : 0));
    d->height = height;
    place_looks(d, (bat_rectangle){2 * em, above(d), wide, bat_max(height - around(d), 8)});
}
