/* Triangles and strokes as pixels, with depth; several samples for each pixel. */
#include "picture/shaded/raster.h"

batten_status bat_raster_make(int width, int rows, bat_raster *out)
{
    const size_t count = (size_t)width * (size_t)rows;
    bat_raster raster = {.width = width, .rows = rows};
    raster.depth = bat_array(count, sizeof *raster.depth);
    raster.colour = bat_array3(count, 3, sizeof *raster.colour);
    if (!raster.depth || !raster.colour) {
        bat_raster_free(&raster);
        return BATTEN_OUT_OF_MEMORY;
    }
    *out = raster;
    return BATTEN_OK;
}

void bat_raster_free(bat_raster *raster)
{
    bat_release(raster->depth);
    bat_release(raster->colour);
}

void bat_raster_begin(bat_raster *raster, int first_row, int height, const float top[3],
                      const float bottom[3])
{
    raster->first_row = first_row;
    for (int j = 0; j < raster->rows; j++) {
        const float t = ((float)(first_row + j) + 0.5f) / (float)height;
        float *colour = raster->colour + 3 * (size_t)j * (size_t)raster->width;
        float *depth = raster->depth + (size_t)j * (size_t)raster->width;
        for (int i = 0; i < raster->width; i++) {
            depth[i] = -HUGE_VALF;
            for (int k = 0; k < 3; k++)
                colour[3 * i + k] = top[k] + t * (bottom[k] - top[k]);
        }
    }
}

/* ---- triangles ---- */

/* A triangle made ready: the weight of corner k at (x, y) is at[k] + along[k] x + down[k] y. */
typedef struct {
    const bat_corner *corners[3];
    double at[3], along[3], down[3];
    int left, right, top, bottom; /* samples that can lie inside */
} triangle;

static double least(double a, double b, double c)
{
    return bat_min(a, bat_min(b, c));
}

static double most(double a, double b, double c)
{
    return bat_max(a, bat_max(b, c));
}

/* The weights; false for a triangle without area. */
static bool weigh(triangle *t)
{
    const bat_corner *a = t->corners[0], *b = t->corners[1], *c = t->corners[2];
    const double area = (b->x - a->x) * (c->y - a->y) - (c->x - a->x) * (b->y - a->y);
    /* An area below this covers no sample and would only amplify roundings. */
    if (!(fabs(area) > 1e-9))
        return false;
    for (int k = 0; k < 3; k++) {
        const bat_corner *p = t->corners[(k + 1) % 3], *q = t->corners[(k + 2) % 3];
        t->along[k] = (p->y - q->y) / area;
        t->down[k] = (q->x - p->x) / area;
        t->at[k] = (p->x * q->y - q->x * p->y) / area;
    }
    return true;
}

/* Clip the box of the triangle to the band; false when nothing is left. */
static bool bound(const bat_raster *raster, triangle *t)
{
    const bat_corner *a = t->corners[0], *b = t->corners[1], *c = t->corners[2];
    const double left = bat_max(least(a->x, b->x, c->x) - 0.5, 0);
    const double right = bat_min(most(a->x, b->x, c->x) - 0.5, raster->width - 1);
    const double top = bat_max(least(a->y, b->y, c->y) - 0.5, raster->first_row);
    const double bottom =
        bat_min(most(a->y, b->y, c->y) - 0.5, raster->first_row + raster->rows - 1);
    if (!(left <= right && top <= bottom))
        return false;
    t->left = (int)ceil(left);
    t->right = (int)floor(right);
    t->top = (int)ceil(top);
    t->bottom = (int)floor(bottom);
    return true;
}

static void fill_row(bat_raster *raster, const triangle *t, int row, bat_fragment *fragment,
                     bat_shader *shader, const void *user)
{
    const bat_corner *a = t->corners[0], *b = t->corners[1], *c = t->corners[2];
    const size_t start = (size_t)(row - raster->first_row) * (size_t)raster->width;
    const double y = row + 0.5;
    double w[3];
    for (int i = t->left; i <= t->right; i++) {
        for (int k = 0; k < 3; k++)
            w[k] = t->at[k] + t->along[k] * (i + 0.5) + t->down[k] * y;
        /* Both triangles at an edge may take a sample on it: better than none. */
        if (w[0] < -1e-9 || w[1] < -1e-9 || w[2] < -1e-9)
            continue;
        const float depth = (float)(w[0] * a->depth + w[1] * b->depth + w[2] * c->depth);
        if (!(depth > raster->depth[start + (size_t)i]))
            continue;
        for (int n = 0; n < BAT_VALUES; n++)
            fragment->value[n] = w[0] * a->value[n] + w[1] * b->value[n] + w[2] * c->value[n];
        raster->depth[start + (size_t)i] = depth;
        shader(user, fragment, raster->colour + 3 * (start + (size_t)i));
    }
}

void bat_raster_triangle(bat_raster *raster, const bat_corner *a, const bat_corner *b,
                         const bat_corner *c, bat_shader *shader, const void *user)
{
    triangle t = {.corners = {a, b, c}};
    if (!bound(raster, &t) || !weigh(&t))
        return;
    bat_fragment fragment;
    for (int row = t.top; row <= t.bottom; row++)
        fill_row(raster, &t, row, &fragment, shader, user);
}

/* ---- pixels ---- */

/* Light is averaged as light; the square root is sRGB's curve closely enough and the same
 * everywhere. */
static uint32_t encode(float light)
{
    const float clipped = light < 0 ? 0 : light > 1 ? 1 : light;
    return (uint32_t)(255 * sqrtf(clipped) + 0.5f);
}

void bat_raster_resolve(const bat_raster *raster, uint32_t *pixels, size_t stride)
{
    const size_t width = (size_t)raster->width / BAT_SAMPLES;
    const size_t height = (size_t)raster->rows / BAT_SAMPLES;
    for (size_t y = 0; y < height; y++)
        for (size_t x = 0; x < width; x++) {
            float sum[3] = {0, 0, 0};
            for (size_t j = 0; j < BAT_SAMPLES; j++)
                for (size_t i = 0; i < BAT_SAMPLES; i++) {
                    const size_t sample =
                        (y * BAT_SAMPLES + j) * (size_t)raster->width + x * BAT_SAMPLES + i;
                    for (size_t k = 0; k < 3; k++)
                        sum[k] += raster->colour[3 * sample + k];
                }
            const float share = 1.0f / (BAT_SAMPLES * BAT_SAMPLES);
            pixels[y * stride + x] = encode(sum[0] * share) << 16 |
                                     encode(sum[1] * share) << 8 | encode(sum[2] * share);
        }
}
