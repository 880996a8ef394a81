#include "picture/lines/wires.h"
#include "picture/scenes.h"

#include <math.h>

/* The lines of a model as seen from an axonometric view at one scale, cut where they vanish. */
typedef struct {
    bat_wires wires;
    bat_facets facets;
    bat_runs *runs; /* [wires.count] */
} seen;

static const double scale = 100;

static seen look_at(const batten_model *model, const batten_draw_options *options)
{
    seen s = {.wires = {.model = model, .options = options}};
    CHECK_OK(bat_wires_measure(&s.wires));
    const bat_eye eye = {bat_view_make(options->view, options->azimuth, options->elevation),
                         {0, 0, 0},
                         options->distance};
    CHECK_OK(bat_wires_gather(&s.wires, scale));
    CHECK_OK(bat_wires_add_silhouettes(&s.wires, &eye));
    CHECK_OK(bat_wires_facets(&s.wires, &eye, scale, 0, 0, &s.facets));
    s.runs = test_array(s.wires.count, sizeof *s.runs);
    for (size_t i = 0; i < s.wires.count; i++) {
        const bat_stroke *stroke = &s.wires.wires[i].stroke;
        const double *away = s.wires.wires[i].away;
        double *points = test_array(6 * stroke->count, sizeof *points);
        double *probes = points + 3 * stroke->count;
        for (size_t k = 0; k < stroke->count; k++) {
            double q[3], out[3];
            for (int n = 0; n < 3; n++)
                out[n] = stroke->points[3 * k + (size_t)n] +
                         (away ? 0.4 / scale * away[3 * k + (size_t)n] : 0);
            bat_eye_project(&eye, stroke->points + 3 * k, q);
            memcpy(points + 3 * k, (double[3]){scale * q[0], -scale * q[1], scale * q[2]},
                   sizeof q);
            bat_eye_project(&eye, out, q);
            memcpy(probes + 3 * k, (double[3]){scale * q[0], -scale * q[1], scale * q[2]},
                   sizeof q);
        }
        s.runs[i] = (bat_runs){0};
        CHECK_OK(bat_runs_cut(&s.facets, stroke->count, points, probes, 1, &s.runs[i]));
    }
    return s;
}

static void forget(seen *s)
{
    for (size_t i = 0; i < s->wires.count; i++)
        bat_runs_free(&s->runs[i]);
    bat_facets_free(&s->facets);
    bat_wires_free(&s->wires);
}

static double length_of(const bat_run *run)
{
    double length = 0;
    for (size_t k = 1; k < run->count; k++)
        length +=
            hypot(run->xy[2 * k] - run->xy[2 * k - 2], run->xy[2 * k + 1] - run->xy[2 * k - 1]);
    return length;
}

/* The length of what is seen, or hidden, of all lines of a kind. */
static double total(const seen *s, bat_wire_kind kind, bool hidden)
{
    double length = 0;
    for (size_t i = 0; i < s->wires.count; i++)
        for (size_t k = 0; s->wires.wires[i].kind == kind && k < s->runs[i].count; k++)
            if (s->runs[i].runs[k].hidden == hidden)
                length += length_of(&s->runs[i].runs[k]);
    return length;
}

static void add_face(batten_model *model, const double *a, const double *b, const double *c,
                     const double *d)
{
    double points[12];
    memcpy(points, a, 3 * sizeof *a);
    memcpy(points + 3, b, 3 * sizeof *a);
    memcpy(points + 6, d, 3 * sizeof *a);
    memcpy(points + 9, c, 3 * sizeof *a);
    scene_add_surface(model, "face", scene_net(1, 2, 1, 2, points));
}

/* A box of half edges x, y, z about the origin, each face a surface. */
static batten_model *box(double x, double y, double z)
{
    static const int faces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                    {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    double corners[8][3];
    for (int i = 0; i < 8; i++) {
        corners[i][0] = i & 4 ? x : -x;
        corners[i][1] = i & 2 ? y : -y;
        corners[i][2] = i & 1 ? z : -z;
    }
    batten_model *model = scene_empty();
    for (int i = 0; i < 6; i++)
        add_face(model, corners[faces[i][0]], corners[faces[i][1]], corners[faces[i][2]],
                 corners[faces[i][3]]);
    return model;
}

static batten_draw_options hiding(void)
{
    batten_draw_options options = batten_draw_defaults();
    options.view = BATTEN_VIEW_AXONOMETRIC;
    options.hidden = BATTEN_HIDDEN_DROPPED;
    options.silhouettes = true;
    options.isolines = 1;
    return options;
}

TEST(of_a_box_nine_edges_are_seen_and_three_are_hidden)
{
    const double views[][3] = {
        {28, 12, 0}, {-40, 35, 0}, {200, -50, 0}, {77, 5, 0}, {28, 30, 6}};
    for (int v = 0; v < COUNT(views); v++) {
        batten_model *model = box(2, 1, 0.7);
        batten_draw_options options = hiding();
        options.azimuth = views[v][0] * 0.0174532925199433;
        options.elevation = views[v][1] * 0.0174532925199433;
        options.distance = views[v][2];
        seen s = look_at(model, &options);
        CHECK_INT((int)s.wires.count, 12);
        int whole_seen = 0, whole_hidden = 0;
        for (size_t i = 0; i < s.wires.count; i++) {
            CHECK_INT(s.wires.wires[i].kind, BAT_WIRE_EDGE);
            CHECK_INT((int)s.runs[i].count, 1);
            whole_seen += !s.runs[i].runs[0].hidden;
            whole_hidden += s.runs[i].runs[0].hidden;
        }
        CHECK_INT(whole_seen, 9);
        CHECK_INT(whole_hidden, 3);
        forget(&s);
        batten_model_unref(model);
    }
}

TEST(the_outline_of_a_sphere_is_seen_and_half_of_its_lines)
{
    batten_model *model = scene_of(scene_sphere(2));
    batten_draw_options options = hiding();
    options.isolines = 8;
    options.elevation = 0; /* the equator is seen edge on, meridians half */
    options.azimuth = 0.3;
    seen s = look_at(model, &options);
    CHECK_NEAR(total(&s, BAT_WIRE_SILHOUETTE, false), 2 * 3.14159265 * 2 * scale, 2);
    CHECK_NEAR(total(&s, BAT_WIRE_SILHOUETTE, true), 0, 0.1);
    const double front = total(&s, BAT_WIRE_ISOLINE, false);
    const double back = total(&s, BAT_WIRE_ISOLINE, true);
    CHECK_NEAR(front / back, 1, 0.01);
    forget(&s);
    batten_model_unref(model);
}

TEST(one_surface_hides_another_just_where_it_covers_it)
{
    /* From above: a square of side 2 before a square of side 6, both 10 edges apart. */
    batten_model *model = scene_empty();
    const double near[] = {-1, -1, 1, -1, 1, 1, 1, -1, 1, 1, 1, 1};
    const double far[] = {-3, -0.5, 0, -3, 0.5, 0, 3, -0.5, 0, 3, 0.5, 0};
    scene_add_surface(model, "near", scene_net(1, 2, 1, 2, near));
    scene_add_surface(model, "far", scene_net(1, 2, 1, 2, far));
    batten_draw_options options = hiding();
    options.view = BATTEN_VIEW_TOP;
    seen s = look_at(model, &options);
    CHECK_NEAR(total(&s, BAT_WIRE_EDGE, false), (8 + 2 * 1 + 2 * (6 - 2)) * scale, 1e-6);
    CHECK_NEAR(total(&s, BAT_WIRE_EDGE, true), 2 * 2 * scale, 1e-6);
    for (size_t i = 0; i < s.wires.count; i++)
        for (size_t k = 0; k < s.runs[i].count; k++)
            if (s.runs[i].runs[k].hidden)
                CHECK_NEAR(fabs(s.runs[i].runs[k].xy[0]), scale, 1e-6);
    forget(&s);
    batten_model_unref(model);
}

static void draw(const batten_model *model, const batten_draw_options *options)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw_surface_lines(model, options, NULL, &data, &size));
    CHECK(size > 500);
    batten_release(data);
}

TEST(every_sheet_is_drawn_in_every_format)
{
    batten_model *model = scene_of(scene_torus(3, 1));
    scene_add_curve(model, "circle", scene_circle(2));
    batten_draw_options options = hiding();
    options.width = 240;
    options.height = 160;
    options.contours = true;
    for (int sheet = 0; sheet <= BATTEN_SHEET_STEREO_CROSSED; sheet++) {
        options.sheet = (batten_sheet)sheet;
        options.hidden = (batten_hidden)(sheet % 3);
        options.format = (batten_picture_format)(sheet % 3);
        options.distance = sheet == 1 ? 20 : 0;
        draw(model, &options);
    }
    batten_model_unref(model);
}

TEST(bad_line_drawings_are_refused)
{
    batten_model *model = scene_of(scene_sphere(1)), *empty = scene_empty();
    char *data = NULL;
    size_t size = 0;
    batten_draw_options options = hiding();
    CHECK_STATUS(batten_draw_surface_lines(empty, &options, NULL, &data, &size),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("of the 0 objects");
    options.distance = 1;
    CHECK_STATUS(batten_draw_surface_lines(model, &options, NULL, &data, &size),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the eye is 1 before the middle");
    options = hiding();
    options.contours = true;
    options.contour_spacing = 1e-5;
    CHECK_STATUS(batten_draw_surface_lines(model, &options, NULL, &data, &size),
                 BATTEN_TOO_LARGE);
    options.contour_spacing = (double)NAN;
    CHECK_STATUS(batten_draw_surface_lines(model, &options, NULL, &data, &size),
                 BATTEN_BAD_ARGUMENT);
    CHECK(data == NULL);
    batten_model_unref(empty);
    batten_model_unref(model);
}
