#include "picture/lines/wires.h"
#include "picture/scenes.h"

#include <math.h>
#include <stdlib.h>

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

/* The words of a drawing, one after the other, with a blank between. */
static const char *words_of(const batten_model *model, batten_draw_options *options)
{
    enum { ROOM = 20000 };
    char *data = NULL, *text = test_array(ROOM, 1);
    size_t size = 0, length = 0;
    options->format = BATTEN_PICTURE_PDF;
    CHECK_OK(batten_draw_surface_lines(model, options, NULL, &data, &size));
    const scene_words words = scene_read_pdf(data, size);
    scene_check_words(&words, options->width, options->height);
    for (int i = 0; i < words.count && length + 66 < ROOM; i++)
        length += (size_t)snprintf(text + length, ROOM - length, " %s", words.words[i].text);
    strcat(text, " ");
    batten_release(data);
    return text;
}

/* Fields of a paraboloid in metres, with what is written below. */
static const struct {
    batten_field_kind kind;
    double apart;
    const char *legend;
} legends[] = {
    {BATTEN_FIELD_HEIGHT, 0.5, " contours of height, 0.5 m apart "},
    {BATTEN_FIELD_GAUSSIAN, 0.25, " contours of Gaussian curvature, 0.25 1/m\u00b2 apart "},
    {BATTEN_FIELD_MEAN, 0.125, " contours of mean curvature, 0.125 1/m apart "},
    {BATTEN_FIELD_KAPPA1, 0.5, " contours of larger principal curvature, 0.5 1/m apart "},
    {BATTEN_FIELD_KAPPA2, 0.5, " contours of smaller principal curvature, 0.5 1/m apart "},
    {BATTEN_FIELD_ISOPHOTE, 0.1, " contours of light n \u00b7 l, 0.1 apart "},
    {BATTEN_FIELD_DRAFT, 0.2, " contours of draft angle, 0.2 rad apart "},
};

/* z = x^2 + y^2 over [-1, 1]^2. */
static batten_model *bowl(void)
{
    static const double z[3] = {1, -1, 1};
    double points[9][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            memcpy(points[3 * i + j], (double[]){i - 1, j - 1, z[i] + z[j]}, sizeof points[0]);
    return scene_of(scene_net(2, 3, 2, 3, points[0]));
}

TEST(the_legend_names_the_field_and_how_far_its_contours_are_apart)
{
    batten_model *model = bowl();
    for (int i = 0; i < COUNT(legends); i++) {
        batten_draw_options options = hiding();
        options.width = 600;
        options.height = 400;
        options.contours = true;
        options.contour_field.kind = legends[i].kind;
        options.contour_field.direction = (batten_vec3){0, 0, 1};
        options.contour_spacing = legends[i].apart;
        const char *text = words_of(model, &options);
        if (!strstr(text, legends[i].legend))
            fprintf(stderr, "%s\n", text);
        CHECK(strstr(text, legends[i].legend));
    }
    batten_model_unref(model);
}

/* A plane of the given breadth that rises by 2.9 over a length of 4: levels from 0.5 to 2.5 cross it. */
static batten_model *slope(double breadth)
{
    const double points[] = {0, 0, 0, 0, breadth, 0, 4, 0, 2.9, 4, breadth, 2.9};
    return scene_of(scene_net(1, 2, 1, 2, points));
}

TEST(contours_have_their_values_beside_them_where_there_is_room)
{
    static const char *const labels[] = {" 1 ", " 1.5 ", " 2 ", " 2.5 "};
    for (int narrow = 0; narrow < 2; narrow++) {
        batten_model *model = slope(narrow ? 0.1 : 3);
        batten_draw_options options = hiding();
        options.view = BATTEN_VIEW_TOP;
        options.width = 600;
        options.height = 450;
        options.contours = true;
        options.contour_spacing = 0.5;
        options.title = "Ramp";
        const char *text = words_of(model, &options);
        CHECK(strstr(text, " Ramp "));
        for (int i = 0; i < COUNT(labels); i++)
            CHECK_INT(strstr(text, labels[i]) != NULL, !narrow);
        batten_model_unref(model);
    }
}

/* What an SVG says of its lines. */
static const char *svg_of(const batten_model *model, batten_draw_options *options)
{
    char *data = NULL;
    size_t size = 0;
    options->format = BATTEN_PICTURE_SVG;
    CHECK_OK(batten_draw_surface_lines(model, options, NULL, &data, &size));
    char *text = test_array(size + 1, 1);
    memcpy(text, data, size);
    batten_release(data);
    return text;
}

/* How many lines of an SVG have this width. */
static int count_width(const char *svg, double width)
{
    static const char name[] = "stroke-width";
    int count = 0;
    for (const char *at = strstr(svg, name); at; at = strstr(at + 1, name)) {
        at += sizeof name - 1;
        count += fabs(strtod(at + strspn(at, ":=\" "), NULL) - width) < 1e-6;
    }
    return count;
}

TEST(lines_are_as_strong_as_their_kind_and_hidden_ones_thin_and_dashed)
{
    static const double above[] = {0, 1, 9, 4, 2, 9}, below[] = {1, 1, -9, 3, 2, -9};
    batten_model *model = slope(3);
    scene_add_curve(model, "above", scene_curve(3, 1, 2, above));
    scene_add_curve(model, "below", scene_curve(3, 1, 2, below));
    batten_draw_options options = hiding();
    options.view = BATTEN_VIEW_TOP;
    options.isolines = 3;
    options.contours = true;
    options.contour_spacing = 0.5;
    for (int dashed = 0; dashed < 2; dashed++) {
        options.hidden = dashed ? BATTEN_HIDDEN_DASHED : BATTEN_HIDDEN_DROPPED;
        const char *svg = svg_of(model, &options);
        CHECK_INT(count_width(svg, 0.5), 4);       /* isolines, two in each direction */
        CHECK_INT(count_width(svg, 0.9), 4);       /* contours */
        CHECK_INT(count_width(svg, 0.9 * 1.7), 1); /* the fifth */
        CHECK_INT(count_width(svg, 1.4), 4);       /* edges */
        CHECK_INT(count_width(svg, 1.8), 1);       /* the curve above */
        CHECK_INT(count_width(svg, 1.08), dashed); /* and the one below */
        CHECK_INT(strstr(svg, "dasharray") != NULL, dashed);
    }
    batten_model_unref(model);
}
