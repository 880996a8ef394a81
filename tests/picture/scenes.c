#define _XOPEN_SOURCE 700
#include "scenes.h"

#include <cairo.h>
#include <stdlib.h>

/* ---- models ---- */

batten_model *scene_empty(void)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    return model;
}

void scene_add_surface(batten_model *model, const char *name, batten_surface *surface)
{
    const batten_object object = {
        .name = name, .layer = "", .kind = BATTEN_OBJECT_SURFACE, .surface = surface};
    CHECK_OK(batten_model_add(model, &object));
    batten_surface_unref(surface);
}

void scene_add_curve(batten_model *model, const char *name, batten_curve *curve)
{
    const batten_object object = {.name = name,
                                  .layer = "",
                                  .kind = BATTEN_OBJECT_CURVE,
                                  .curve = curve,
                                  .has_colour = true,
                                  .colour = {1, 0, 0}};
    CHECK_OK(batten_model_add(model, &object));
    batten_curve_unref(curve);
}

batten_model *scene_of(batten_surface *surface)
{
    batten_model *model = scene_empty();
    scene_add_surface(model, "shape", surface);
    return model;
}

static double *even_knots(int degree, int count)
{
    double *knots = test_array(count + degree + 1, sizeof *knots);
    for (int i = 0; i < count + degree + 1; i++) {
        const int inner = i - degree, last = count - degree;
        knots[i] = inner < 0 ? 0 : inner > last ? 1 : (double)inner / last;
    }
    return knots;
}

batten_surface *scene_net(int p, int count_u, int q, int count_v, const double *points)
{
    const batten_axis u = {p, count_u, even_knots(p, count_u), false};
    const batten_axis v = {q, count_v, even_knots(q, count_v), false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &surface));
    return surface;
}

batten_curve *scene_curve(int dimension, int degree, int count, const double *points)
{
    const double *knots = even_knots(degree, count);
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){dimension, count, points}, degree, NULL, knots,
                                 &curve));
    return curve;
}

/* The circle as four rational quadratic quarters. */
static const double quarter_knots[] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
static const double square[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                    {-1, -1}, {0, -1}, {1, -1}, {1, 0}};

static double quarter_weight(int i)
{
    return i % 2 == 1 ? sqrt(0.5) : 1;
}

batten_curve *scene_circle(double radius)
{
    double points[9][2], weights[9];
    for (int i = 0; i < 9; i++) {
        points[i][0] = radius * square[i][0];
        points[i][1] = radius * square[i][1];
        weights[i] = quarter_weight(i);
    }
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 9, points[0]}, 2, weights, quarter_knots,
                                 &curve));
    return curve;
}

batten_surface *scene_turned(int count, const double *profile)
{
    double *points = test_array(9 * count * 3, sizeof *points);
    double *weights = test_array(9 * count, sizeof *weights);
    double *knots = test_array(count + 3, sizeof *knots);
    for (int i = 0; i < count + 3; i++)
        knots[i] = i < 3 ? 0 : i >= count ? (count - 1) / 2 : (i - 1) / 2;
    for (int i = 0; i < 9; i++)
        for (int j = 0; j < count; j++) {
            const double *row = profile + 3 * j;
            double *p = points + 3 * (i * count + j);
            p[0] = row[0] * square[i][0];
            p[1] = row[0] * square[i][1];
            p[2] = row[1];
            weights[i * count + j] = row[2] * quarter_weight(i);
        }
    const batten_axis u = {2, 9, quarter_knots, false}, v = {2, count, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, weights, &surface));
    return surface;
}

batten_surface *scene_sphere(double r)
{
    const double w = sqrt(0.5);
    const double profile[] = {0, -r, 1, r, -r, w, r, 0, 1, r, r, w, 0, r, 1};
    return scene_turned(5, profile);
}

batten_surface *scene_torus(double major, double minor)
{
    double profile[9][3];
    for (int i = 0; i < 9; i++) {
        profile[i][0] = major + minor * square[i][0];
        profile[i][1] = minor * square[i][1];
        profile[i][2] = quarter_weight(i);
    }
    return scene_turned(9, profile[0]);
}

batten_surface *scene_cylinder(double radius, double length)
{
    double points[9][2][3], weights[9][2];
    for (int i = 0; i < 9; i++)
        for (int j = 0; j < 2; j++) {
            points[i][j][0] = (j - 0.5) * length;
            points[i][j][1] = radius * square[i][0];
            points[i][j][2] = radius * square[i][1];
            weights[i][j] = quarter_weight(i);
        }
    const double knots[] = {0, 0, 1, 1};
    const batten_axis u = {2, 9, quarter_knots, false}, v = {1, 2, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points[0][0], weights[0], &surface));
    return surface;
}

batten_surface *scene_wigley(double length, double beam, double draught, double side)
{
    static const double fullness[] = {0, 1, 1}, middle[] = {0, 2, 0};
    double points[3][3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            points[i][j][0] = 0.5 * length * (i - 1);
            points[i][j][1] = side * 0.5 * beam * middle[i] * fullness[j];
            points[i][j][2] = 0.5 * draught * (j - 2);
        }
    return scene_net(2, 3, 2, 3, points[0][0]);
}

batten_draw_lines_plan_options scene_plan(double length)
{
    batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
    if (test_cases(10) < 10)
        plan.stations = plan.waterlines = plan.buttocks = 0.4 * length;
    return plan;
}

/* ---- pictures ---- */

typedef struct {
    const char *data;
    size_t size, used;
} source;

static cairo_status_t take(void *closure, unsigned char *data, unsigned length)
{
    source *s = closure;
    if (length > s->size - s->used)
        return CAIRO_STATUS_READ_ERROR;
    memcpy(data, s->data + s->used, length);
    s->used += length;
    return CAIRO_STATUS_SUCCESS;
}

scene_image scene_decode(const char *data, size_t size)
{
    source s = {data, size, 0};
    cairo_surface_t *image = cairo_image_surface_create_from_png_stream(take, &s);
    CHECK_INT(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
    const int width = cairo_image_surface_get_width(image);
    const int height = cairo_image_surface_get_height(image);
    uint32_t *pixels = test_array((size_t)width * height, sizeof *pixels);
    const unsigned char *rows = cairo_image_surface_get_data(image);
    for (int y = 0; y < height; y++)
        memcpy(pixels + (size_t)y * width,
               rows + (size_t)y * cairo_image_surface_get_stride(image), (size_t)width * 4);
    cairo_surface_destroy(image);
    return (scene_image){width, height, pixels};
}

uint32_t scene_pixel(const scene_image *image, int x, int y)
{
    CHECK(x >= 0 && x < image->width && y >= 0 && y < image->height);
    return image->pixels[(size_t)y * image->width + x] & 0xffffff;
}

int scene_red(uint32_t pixel)
{
    return pixel >> 16 & 255;
}

int scene_green(uint32_t pixel)
{
    return pixel >> 8 & 255;
}

int scene_blue(uint32_t pixel)
{
    return pixel & 255;
}

/* ---- text ---- */

scene_words scene_read_pdf(const char *data, size_t size)
{
    const char *path = test_scratch("words.pdf");
    FILE *file = fopen(path, "wb");
    CHECK(file && fwrite(data, 1, size, file) == size);
    CHECK(fclose(file) == 0);
    char command[512], line[512];
    snprintf(command, sizeof command, "pdftotext -bbox %s - 2>/dev/null", path);
    FILE *pipe = popen(command, "r");
    CHECK(pipe != NULL);

    scene_words words = {0, test_array(2000, sizeof(scene_word))};
    while (fgets(line, sizeof line, pipe) && words.count < 2000) {
        scene_word *w = &words.words[words.count];
        if (sscanf(line, " <word xMin=\"%lf\" yMin=\"%lf\" xMax=\"%lf\" yMax=\"%lf\">%63[^<]",
                   &w->left, &w->top, &w->right, &w->bottom, w->text) == 5)
            words.count++;
    }
    if (pclose(pipe) != 0)
        SKIP("pdftotext is not installed");
    return words;
}

const scene_word *scene_find(const scene_words *words, const char *text)
{
    for (int i = 0; i < words->count; i++)
        if (strcmp(words->words[i].text, text) == 0)
            return &words->words[i];
    return NULL;
}

/* pdftotext gives the height of the font, which is more than that of its figures. */
static bool overlap(const scene_word *a, const scene_word *b)
{
    const double in_a = 0.22 * (a->bottom - a->top), in_b = 0.22 * (b->bottom - b->top);
    return a->left + 0.5 < b->right && b->left + 0.5 < a->right &&
           a->top + in_a < b->bottom - in_b && b->top + in_b < a->bottom - in_a;
}

void scene_check_words(const scene_words *words, double width, double height)
{
    for (int i = 0; i < words->count; i++) {
        const scene_word *a = &words->words[i];
        CHECK(a->left >= 0 && a->top >= 0 && a->right <= width && a->bottom <= height);
        for (int k = 0; k < i; k++)
            if (overlap(a, &words->words[k])) {
                fprintf(stderr, "\"%s\" at %g, %g lies on \"%s\" at %g, %g\n", a->text, a->left,
                        a->top, words->words[k].text, words->words[k].left,
                        words->words[k].top);
                CHECK(!"two words overlap");
            }
    }
}
