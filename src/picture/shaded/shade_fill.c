/* The samples of a shaded picture: their colours, and surfaces, meshes and curves filled in. */
#include "picture/shaded/shade.h"

/* ---- colours of samples ---- */

static void set_sample(bat_light light, float colour[3])
{
    colour[0] = (float)light.red;
    colour[1] = (float)light.green;
    colour[2] = (float)light.blue;
}

static void shade_solid(const void *user, const bat_fragment *f, float colour[3])
{
    const bat_shaded_solid *s = user;
    double n[3] = {f->value[BAT_SAMPLE_NORMAL], f->value[BAT_SAMPLE_NORMAL + 1],
                   f->value[BAT_SAMPLE_NORMAL + 2]};
    const double length = sqrt(bat_dot(3, n, n));
    /* Where no corner has a normal, the surface is taken to face the eye. */
    for (int k = 0; k < 3; k++)
        n[k] = length > 0 ? n[k] / length : s->scene->eye[k];

    set_sample(bat_light_of_sample(s->scene, s->albedo, f->value[BAT_SAMPLE_CURVATURE], n),
               colour);
}

static void shade_flat(const void *user, const bat_fragment *f, float colour[3])
{
    (void)f;
    set_sample(*(const bat_light *)user, colour);
}

/* ---- filling ---- */

static bat_corner corner(const bat_shaded_solid *s, size_t i, size_t j)
{
    const bat_tiles *t = &s->tiles;
    const size_t at = i * t->count_v + j;
    const double *p = t->points + 3 * at, *n = t->normals + 3 * at;
    return (bat_corner){
        p[0], p[1], p[2], {n[0], n[1], n[2], t->curvature ? t->curvature[at] : 0}};
}

/* Does the cell reach into the band? Most do not, and making corners costs more than asking. */
static bool touches(const bat_raster *band, const bat_shaded_solid *s, size_t i, size_t j)
{
    const size_t n = s->tiles.count_v, at = i * n + j;
    const double *y = s->tiles.points + 1;
    const double a = y[3 * at], b = y[3 * (at + 1)], c = y[3 * (at + n)],
                 d = y[3 * (at + n + 1)];
    return bat_max(bat_max(a, b), bat_max(c, d)) >= band->first_row &&
           bat_min(bat_min(a, b), bat_min(c, d)) <= band->first_row + band->rows;
}

static void fill_solid(bat_raster *band, const bat_shaded_solid *s)
{
    for (size_t i = 0; i + 1 < s->tiles.count_u; i++)
        for (size_t j = 0; j + 1 < s->tiles.count_v; j++) {
            if (!touches(band, s, i, j))
                continue;
            const bat_corner a = corner(s, i, j), b = corner(s, i + 1, j);
            const bat_corner c = corner(s, i + 1, j + 1), d = corner(s, i, j + 1);
            bat_raster_triangle(band, &a, &b, &c, shade_solid, s);
            bat_raster_triangle(band, &a, &c, &d, shade_solid, s);
        }
}

/* A segment as two triangles, `half` samples to both sides and beyond its ends, a little nearer
 * to the eye than the surface that it lies on. */
static void fill_segment(bat_raster *band, const double *from, const double *to, double half,
                         double nearer, const bat_light *light)
{
    double x = to[0] - from[0], y = to[1] - from[1];
    if (bat_max(from[1], to[1]) + half < band->first_row ||
        bat_min(from[1], to[1]) - half > band->first_row + band->rows)
        return;
    const double length = bat_hypot(x, y);
    x = length > 0 ? half * x / length : half;
    y = length > 0 ? half * y / length : 0;
    bat_corner c[4] = {{.x = from[0] - x - y, .y = from[1] - y + x, .depth = from[2] + nearer},
                       {.x = from[0] - x + y, .y = from[1] - y - x, .depth = from[2] + nearer},
                       {.x = to[0] + x + y, .y = to[1] + y - x, .depth = to[2] + nearer},
                       {.x = to[0] + x - y, .y = to[1] + y + x, .depth = to[2] + nearer}};
    bat_raster_triangle(band, &c[0], &c[1], &c[2], shade_flat, light);
    bat_raster_triangle(band, &c[0], &c[2], &c[3], shade_flat, light);
}

/* Lines on a surface or mesh, `half` a width to both sides, in a dark shade of its colour. */
static void fill_lines(bat_raster *band, const bat_strokes *lines, double half, double shade,
                       bat_light albedo)
{
    const bat_light ink = {shade * albedo.red, shade * albedo.green, shade * albedo.blue};
    const double nearer = 2 * BAT_SAMPLES;
    for (size_t i = 0; i < lines->count; i++) {
        const bat_stroke *s = &lines->strokes[i];
        for (size_t k = 0; k + 1 < s->count; k++)
            fill_segment(band, s->points + 3 * k, s->points + 3 * (k + 1), half, nearer, &ink);
    }
}

/* Isolines are a pixel wide, edges half as much again and darker. */
static void fill_lines_of_all(bat_raster *band, const bat_shaded *p)
{
    const double thin = 0.5 * BAT_SAMPLES, strong = 0.7 * BAT_SAMPLES;
    const double pale = 0.09, dark = 0.05;
    for (int i = 0; i < p->solid_count; i++)
        fill_lines(band, &p->solids[i].isolines, thin, pale, p->solids[i].albedo);
    for (int i = 0; i < p->solid_count; i++)
        fill_lines(band, &p->solids[i].edges, strong, dark, p->solids[i].albedo);
    for (int i = 0; i < p->mesh_count; i++)
        fill_lines(band, &p->meshes[i].lines, strong, dark, p->meshes[i].albedo);
}

/* A disc that faces the eye, before the surface by its radius: a point on it, or near it, is
 * seen whole. */
static void fill_dot(bat_raster *band, const double *at, const bat_shaded_style *i)
{
    enum { CORNERS = 10 };
    if (at[1] + i->dot < band->first_row || at[1] - i->dot > band->first_row + band->rows)
        return;
    bat_corner c[3] = {{.x = at[0], .y = at[1], .depth = at[2] + i->dot}};
    c[1] = c[2] = c[0];
    c[2].x += i->dot;
    for (int k = 1; k <= CORNERS; k++) {
        const double angle = 2 * BAT_PI * k / CORNERS;
        c[1] = c[2];
        c[2].x = at[0] + i->dot * bat_cos(angle);
        c[2].y = at[1] + i->dot * bat_sin(angle);
        bat_raster_triangle(band, &c[0], &c[1], &c[2], shade_flat, &i->light);
    }
}

static void fill_curves(bat_raster *band, const bat_shaded *p)
{
    const double half = 0.9 * BAT_SAMPLES, nearer = 3 * BAT_SAMPLES;
    for (size_t i = 0; i < p->curves.count; i++) {
        const bat_stroke *s = &p->curves.strokes[i];
        const bat_shaded_style *how = &p->styles[i];
        for (size_t k = 0; how->dot > 0 && k < s->count; k++)
            fill_dot(band, s->points + 3 * k, how);
        for (size_t k = 0; !(how->dot > 0) && k + 1 < s->count; k++)
            fill_segment(band, s->points + 3 * k, s->points + 3 * (k + 1), half, nearer,
                         &how->light);
    }
}

static batten_status ask(const bat_shaded *p, double fraction)
{
    batten_job job = BATTEN_JOB;
    const batten_status taken = BAT_TAKE_OPTIONS(batten_job, p->job, &job);
    if (taken != BATTEN_OK)
        return taken;
    if (job.progress)
        job.progress(job.user, fraction, "shading");
    if (job.is_cancelled && job.is_cancelled(job.user))
        return bat_fail(BATTEN_CANCELLED, "cancelled after %.0f %% of the picture",
                        100 * fraction);
    return BATTEN_OK;
}

batten_status bat_shaded_fill(const bat_shaded *p, bat_canvas *canvas)
{
    enum { BAND = 32 };
    const int width = p->options->width, height = p->options->height;
    cairo_surface_t *image = canvas->surface;
    cairo_surface_flush(image);
    /* cairo aligns its rows so that they may be read as words. */
    uint32_t *pixels = (uint32_t *)(void *)cairo_image_surface_get_data(image);
    const size_t stride = (size_t)cairo_image_surface_get_stride(image) / sizeof *pixels;
    if (!pixels)
        return bat_fail(BATTEN_OUT_OF_MEMORY, "no memory for a picture of %d x %d", width,
                        height);

    static const float top[3] = {1, 1, 1}, bottom[3] = {0.80f, 0.84f, 0.88f};
    bat_raster band;
    batten_status status = bat_raster_make(width * BAT_SAMPLES, BAND * BAT_SAMPLES, &band);
    if (status != BATTEN_OK)
        return status;
    for (int y = 0; y < height && status == BATTEN_OK; y += BAND) {
        band.rows = BAT_SAMPLES * bat_min_int(BAND, height - y);
        bat_raster_begin(&band, y * BAT_SAMPLES, height * BAT_SAMPLES, top, bottom);
        for (int i = 0; i < p->solid_count; i++)
            fill_solid(&band, &p->solids[i]);
        for (int i = 0; i < p->mesh_count; i++)
            bat_mesh_solid_fill(&band, &p->meshes[i]);
        fill_lines_of_all(&band, p);
        fill_curves(&band, p);
        bat_raster_resolve(&band, pixels + (size_t)y * stride, stride);
        status = ask(p, (double)y / height);
    }
    bat_raster_free(&band);
    cairo_surface_mark_dirty(image);
    return status;
}
