#include "exchange/reading.h"
#include "exchange/shapes/paths.h"

TEST(svg_is_at_true_scale_with_arcs_as_arcs)
{
    batten_model *model = model_of("a<b", stadium());
    const char *text = written(model, BATTEN_FORMAT_SVG);
    CHECK_CONTAINS(text, "mm\" viewBox=\"0 0 ");
    CHECK_CONTAINS(text, "id=\"a&lt;b\"");
    CHECK_CONTAINS(text, "A10 10 0 0 0 "); /* counter-clockwise, though y counts downwards */
    CHECK_CONTAINS(text, "Z\"/>");
    batten_model_unref(model);
}

/* The numbers after the first M of a path. */
static int coordinates(const char *text, double *out, int room)
{
    const char *at = strstr(text, " d=\"M");
    int count = 0, used = 0;
    CHECK(at != NULL);
    for (at += 5; *at != '"' && count < room; at += used) {
        if (*at == 'C' || *at == ' ' || *at == 'L') {
            used = 1;
            continue;
        }
        CHECK(sscanf(at, "%lf%n", &out[count], &used) == 1);
        count++;
    }
    return count;
}

TEST(svg_of_a_nurbs_curve_of_lines_and_arcs_has_arcs)
{
    batten_model *model = model_of_curve(filleted(0, 0), "frame");
    const char *text = written(model, BATTEN_FORMAT_SVG);
    CHECK(strchr(strstr(text, " d=\"M"), 'C') == NULL);
    CHECK_CONTAINS(text, " 0 0 0 ");
    double x, y, rx, ry;
    CHECK(sscanf(strchr(strstr(text, " d=\"M"), 'L'), "L%lf %lfA%lf %lf", &x, &y, &rx, &ry) ==
          4);
    CHECK_NEAR(x, 75, 1e-11);
    CHECK_NEAR(y, 55, 1e-11);
    CHECK_NEAR(rx, 10, 1e-11);
    batten_model_unref(model);
}

/* Of 30 by 20, of degree 4: no arc to the format. */
static batten_curve *raised_ellipse(double to)
{
    batten_curve *ellipse = NULL, *raised = NULL;
    CHECK_OK(batten_curve_ellipse(30, 20, 0, to, &ellipse));
    CHECK_OK(batten_curve_elevate(ellipse, 2, &raised));
    batten_curve_unref(ellipse);
    return raised;
}

TEST(svg_of_a_curve_is_within_the_tolerance)
{
    batten_model *model = NULL;
    batten_curve *curve = NULL;
    batten_write_options options = batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(0.001, &model));
    curve = raised_ellipse(2 * acos(-1));
    const batten_object object = {
        .name = "ellipse", .layer = "", .kind = BATTEN_OBJECT_CURVE, .curve = curve};
    CHECK_OK(batten_model_add(model, &object));
    options.format = BATTEN_FORMAT_SVG;
    options.tolerance = 1e-3;
    CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
    double c[2000];
    const int count = coordinates(data, c, 2000) / 2;
    /* The sheet begins 5 mm left of the box of the control points, of 60 by 40. */
    for (int i = 0; i + 3 < count; i += 3)
        for (int k = 0; k <= 20; k++) {
            const double t = k / 20.0, s = 1 - t;
            double at[2];
            for (int a = 0; a < 2; a++)
                at[a] = s * s * s * c[2 * i + a] + 3 * s * s * t * c[2 * i + 2 + a] +
                        3 * s * t * t * c[2 * i + 4 + a] + t * t * t * c[2 * i + 6 + a];
            /* The distance from the ellipse, to first order. */
            const double x = (at[0] - 35) / 30, y = (at[1] - 25) / 20;
            const double off = (x * x + y * y - 1) / (2 * hypot(x / 30, y / 20));
            CHECK_NEAR(off, 0, 1.1e-3);
        }
    batten_release(data);
    batten_curve_unref(curve);
    batten_model_unref(model);
}

TEST(svg_notes_what_is_beyond_the_tolerance)
{
    batten_model *model = NULL;
    batten_curve *curve = NULL;
    batten_write_options options = batten_write_defaults();
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_notes_create(4, &notes));
    CHECK_OK(batten_model_create(0.001, &model));
    curve = raised_ellipse(1);
    const batten_object object = {
        .name = "arc", .layer = "", .kind = BATTEN_OBJECT_CURVE, .curve = curve};
    CHECK_OK(batten_model_add(model, &object));
    options.format = BATTEN_FORMAT_SVG;
    options.tolerance = 1e-300; /* halving comes to an end at the rounding */
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    /* Twice where memory failed and it was written again. */
    CHECK(batten_notes_count(notes) + batten_notes_dropped(notes) >= 1);
    bool said = batten_notes_dropped(notes) > 0;
    for (int i = 0; i < batten_notes_count(notes); i++)
        said |=
            strstr(batten_notes_at(notes, i)->text, "not within the tolerance 1e-300") != NULL;
    CHECK(said);
    batten_release(data);
    batten_curve_unref(curve);
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(svg_says_once_that_all_curves_stand_upright)
{
    for (int mixed = 0; mixed < 2; mixed++) {
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        batten_write_options options = batten_write_defaults();
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(batten_model_create(1, &model));
        for (int i = 0; i < 3; i++) {
            const double x = i, far = mixed && i == 2 ? 9 : x + 1e-9;
            const double points[] = {x, 0, 0, x, 2, 1, far, 3, 4};
            const double knots[] = {0, 0, 0, 1, 1, 1};
            batten_curve *curve = NULL;
            CHECK_OK(
                batten_curve_create((batten_points){3, 3, points}, 2, NULL, knots, &curve));
            CHECK_OK(batten_model_add(model, &(batten_object){.name = "station",
                                                              .kind = BATTEN_OBJECT_CURVE,
                                                              .curve = curve}));
            batten_curve_unref(curve);
        }
        options.format = BATTEN_FORMAT_SVG;
        CHECK_OK(batten_notes_create(9, &notes));
        CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
        if (batten_notes_dropped(notes) == 0) {
            CHECK(has_note(notes, "all curves lie in planes x = constant") == !mixed);
            CHECK(has_note(notes, "it is drawn as seen along z") == mixed);
        }
        batten_release(data);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

/* Around an ellipse of 30 by 20 that is turned by 0.5 and moved, seen along z: of degree 2, as
 * readers have it of degree 3, and as a circle that is tilted. */
TEST(svg_of_elliptical_arcs_is_exact_and_no_approximation)
{
    for (int kind = 0; kind < 6; kind++) {
        const bool is_tilted = kind / 2 == 2;
        const double to = kind % 2 ? 2 * acos(-1) : 2, tilt = is_tilted ? acos(20.0 / 30) : 0;
        batten_curve *flat = NULL, *raised = NULL, *curve = NULL;
        CHECK_OK(batten_curve_ellipse(30, is_tilted ? 30 : 20, 0, to, &flat));
        CHECK_OK(batten_curve_elevate(flat, kind / 2 == 1, &raised));
        batten_affine map =
            batten_affine_rotation((batten_vec3){0}, (batten_vec3){1, 0, 0}, tilt);
        map = batten_affine_compose(
            map, batten_affine_rotation((batten_vec3){0}, (batten_vec3){0, 0, 1}, 0.5));
        map = batten_affine_compose(map, batten_affine_scaling(kind % 2 ? 1 : -1, 1, 1));
        map = batten_affine_compose(map, batten_affine_translation(100, -40, 0));
        CHECK_OK(batten_curve_transform(raised, &map, &curve));
        batten_model *model = model_of_curve(curve, "ellipse"), *back = NULL;
        batten_notes *notes = NULL;
        batten_write_options options = batten_write_defaults();
        char *data = NULL;
        size_t size = 0;
        options.format = BATTEN_FORMAT_SVG;
        CHECK_OK(batten_notes_create(9, &notes));
        CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
        CHECK(!has_note(notes, "approximated"));
        const char *path = strstr(data, " d=\"M");
        CHECK(strcspn(path, "A") < strlen(path) && strcspn(path, "CL") == strlen(path));
        CHECK_OK(batten_read_memory(data, size, NULL, NULL, NULL, &back));
        const batten_curve *found = batten_model_object(back, 0)->curve;
        const batten_box box = batten_curve_box(batten_model_object(model, 0)->curve);
        const batten_interval domain = batten_curve_domain(found);
        for (int k = 0; k <= 100; k++) {
            double at[3];
            CHECK_OK(batten_curve_evaluate(found, domain.a + (domain.b - domain.a) * k / 100, 0,
                                           at));
            /* The sheet begins 5 mm left of the box and below it. */
            const double x = (at[0] + box.low.x - 5 - 100) * (kind % 2 ? 1 : -1);
            const double y = at[1] + box.low.y - 5 + 40;
            const double u = cos(0.5) * x + sin(0.5) * y, v = cos(0.5) * y - sin(0.5) * x;
            CHECK_NEAR(hypot(u / 30, v / 20), 1, 1e-13);
        }
        batten_release(data);
        batten_notes_free(notes);
        batten_model_unref(back);
        batten_model_unref(model);
        batten_curve_unref(raised);
        batten_curve_unref(flat);
    }
}

TEST(svg_says_how_far_cubics_are_from_what_they_are_not)
{
    for (int is_cubic = 0; is_cubic < 2; is_cubic++) {
        static const double points[] = {0, 0, 3, 5, 7, 5, 9, -1},
                            knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
        batten_curve *curve = is_cubic ? NULL : raised_ellipse(1);
        if (is_cubic)
            CHECK_OK(
                batten_curve_create((batten_points){2, 4, points}, 3, NULL, knots, &curve));
        batten_model *model = model_of_curve(curve, "bow");
        batten_notes *notes = NULL;
        batten_write_options options = batten_write_defaults();
        char *data = NULL;
        size_t size = 0;
        options.format = BATTEN_FORMAT_SVG;
        options.tolerance = 0.01;
        CHECK_OK(batten_notes_create(9, &notes));
        CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
        if (batten_notes_dropped(notes) == 0)
            CHECK(has_note(notes, "approximated within 0.00") == !is_cubic);
        batten_release(data);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

/* Write curves as SVG, and give their references back. */
static void write_curves(int count, batten_curve *const *curves, batten_status due,
                         batten_notes *notes, char **data)
{
    batten_model *model = NULL;
    batten_write_options options = batten_write_defaults();
    size_t size = 0;
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < count; i++) {
        CHECK_OK(batten_model_add(model, &(batten_object){.name = "curve",
                                                          .kind = BATTEN_OBJECT_CURVE,
                                                          .curve = curves[i]}));
        batten_curve_unref(curves[i]);
    }
    options.format = BATTEN_FORMAT_SVG;
    CHECK_STATUS(batten_write_memory(model, &options, notes, data, &size), due);
    batten_model_unref(model);
}

static batten_curve *line_between(const double from[3], const double to[3])
{
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(3, from, to, &line));
    return line;
}

TEST(svg_of_nothing_but_a_stroke_along_z_is_refused_and_beside_others_noted)
{
    const double foot[3] = {1, 2, 0}, head[3] = {1, 2, 5}, far[3] = {4, 7, 0};
    for (int count = 1; count <= 2; count++) {
        batten_curve *curves[2] = {line_between(foot, head), line_between(foot, far)};
        batten_notes *notes = NULL;
        char *data = NULL;
        CHECK_OK(batten_notes_create(9, &notes));
        write_curves(count, curves, count == 1 ? BATTEN_UNSUPPORTED : BATTEN_OK, notes, &data);
        CHECK(batten_notes_dropped(notes) || has_note(notes, "is one point of the sheet"));
        if (count == 1)
            batten_curve_unref(curves[1]);
        batten_release(data);
        batten_notes_free(notes);
    }
}

TEST(svg_does_not_speak_of_upright_curves_where_the_first_lies_flat)
{
    const double corners[3][3] = {{0, 0, 0}, {3, 4, 0}, {0, 4, 6}};
    batten_curve *curves[2] = {line_between(corners[0], corners[1]),
                               line_between(corners[0], corners[2])};
    batten_notes *notes = NULL;
    char *data = NULL;
    CHECK_OK(batten_notes_create(9, &notes));
    write_curves(2, curves, BATTEN_OK, notes, &data);
    CHECK(!has_note(notes, "all curves lie in planes"));
    CHECK(batten_notes_dropped(notes) || has_note(notes, "its extent from z = 0 to 6 is lost"));
    batten_release(data);
    batten_notes_free(notes);
}

/* Of the ellipse of 30 by 20 from angle 0, with a line before it where it begins. */
static batten_curve *pieces_of_ellipse(bool has_line)
{
    batten_curve *first = NULL, *second = NULL, *joined = NULL;
    if (has_line)
        CHECK_OK(batten_curve_line(2, (double[]){40, 1}, (double[]){30, 0}, &first));
    else
        CHECK_OK(batten_curve_ellipse(30, 20, -0.4, 0.4, &first));
    CHECK_OK(batten_curve_ellipse(30, 20, 0, 1.5, &second));
    CHECK_OK(batten_curve_join(first, second, 1e-9, &joined));
    batten_curve_unref(first);
    batten_curve_unref(second);
    return joined;
}

TEST(svg_knows_an_arc_by_the_weights_of_its_own_piece)
{
    for (int k = 0; k < 2; k++) {
        batten_curve *curve = pieces_of_ellipse(k == 1);
        batten_notes *notes = NULL;
        char *data = NULL;
        CHECK_OK(batten_notes_create(9, &notes));
        write_curves(1, &curve, BATTEN_OK, notes, &data);
        CHECK(!has_note(notes, "approximated"));
        int arcs = 0;
        for (const char *at = strstr(data, " d=\"M"); (at = strchr(at + 1, 'A'));)
            arcs++;
        CHECK_INT(arcs, k == 0 ? 2 : 1);
        batten_release(data);
        batten_notes_free(notes);
    }
}

TEST(svg_approximates_polynomials_of_degree_four)
{
    const double points[] = {0, 0, 10, 30, 20, -40, 30, 50, 40, 0};
    const double knots[] = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1};
    batten_curve *curve = NULL;
    batten_notes *notes = NULL;
    char *data = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 5, points}, 4, NULL, knots, &curve));
    CHECK_OK(batten_notes_create(9, &notes));
    write_curves(1, &curve, BATTEN_OK, notes, &data);
    CHECK(batten_notes_dropped(notes) || has_note(notes, "approximated within"));
    batten_release(data);
    batten_notes_free(notes);
}

/* How many cubics a curve of one span from parameter 3.2107 to 3.2107 + 6e-5 becomes; its points reach 4.9e9. */
static int cubics_of_short_span(int degree)
{
    const double points[] = {21, 5, 21.5, 3e9, 21.6, 4.9e9, 21.7, -2e9, 21.8, 5};
    double knots[10];
    batten_curve *curve = NULL;
    char *data = NULL;
    for (int i = 0; i < 2 * (degree + 1); i++)
        knots[i] = i <= degree ? 3.2107 : 3.2107 + 6e-5;
    CHECK_OK(batten_curve_create((batten_points){2, degree + 1, points}, degree, NULL, knots,
                                 &curve));
    write_curves(1, &curve, BATTEN_OK, NULL, &data);
    int cubics = 0;
    for (const char *at = strstr(data, " d=\"M"); at && (at = strchr(at + 1, 'C'));)
        cubics++;
    batten_release(data);
    return cubics;
}

TEST(svg_does_not_halve_where_the_parameter_has_no_digits_left)
{
    CHECK_INT(cubics_of_short_span(3), 1);
    CHECK(cubics_of_short_span(4) < 2000);
}
