#include "exchange/shapes/paths.h"

#include <batten/exchange.h>
#include <stdlib.h>

static const char *program(const batten_model *model, const batten_write_gcode_options *options)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_write_gcode(model, options, NULL, &data, &size));
    char *text = test_array(size + 1, 1);
    memcpy(text, data, size);
    batten_release(data);
    return text;
}

/* A machine that follows the words, and looks that arcs end on their circle. */
typedef struct {
    double at[3], length, worst;
    int arcs, lines;
} machine;

static bool word(const char *line, char letter, double *value)
{
    const char *found = strchr(line, letter);
    if (found)
        *value = strtod(found + 1, NULL);
    return found != NULL;
}

static void follow_arc(machine *m, const char *line, const double from[3], int g, bool absolute)
{
    double i = 0, j = 0;
    CHECK(word(line, 'I', &i) && word(line, 'J', &j));
    const double cx = absolute ? i : from[0] + i, cy = absolute ? j : from[1] + j;
    const double r0 = hypot(from[0] - cx, from[1] - cy),
                 r1 = hypot(m->at[0] - cx, m->at[1] - cy);
    double turn = atan2(m->at[1] - cy, m->at[0] - cx) - atan2(from[1] - cy, from[0] - cx);
    if (g == 3 && turn <= 0)
        turn += 2 * acos(-1);
    if (g == 2 && turn >= 0)
        turn -= 2 * acos(-1);
    m->worst = fmax(m->worst, fabs(r0 - r1));
    m->length += r0 * fabs(turn);
    m->arcs++;
}

static machine follow(const char *text)
{
    machine m = {{0}, 0, 0, 0, 0};
    bool absolute = strstr(text, "G90.1") != NULL, relative = strstr(text, "G91 (") != NULL;
    for (const char *line = text; line && *line; line = strchr(line, '\n')) {
        char one[200] = "";
        line += *line == '\n';
        memcpy(one, line, strcspn(line, "\n") < 199 ? strcspn(line, "\n") : 199);
        const int g = one[0] == 'G' ? atoi(one + 1) : -1;
        const double from[3] = {m.at[0], m.at[1], m.at[2]};
        double value = 0;
        if (g < 0 || g > 3)
            continue;
        for (int k = 0; k < 3; k++)
            if (word(one, "XYZ"[k], &value))
                m.at[k] = value + (relative ? m.at[k] : 0);
        if (g >= 2)
            follow_arc(&m, one, from, g, absolute);
        if (g == 1 && !strchr(one, 'Z')) {
            m.length += hypot(m.at[0] - from[0], m.at[1] - from[1]);
            m.lines++;
        }
    }
    return m;
}

TEST(a_machine_that_follows_the_program_cuts_the_whole_path)
{
    batten_model *model = model_of("stadium", stadium());
    for (int k = 0; k < 4; k++) {
        batten_write_gcode_options options = batten_write_gcode_defaults();
        options.absolute_centres = k & 1;
        options.relative_moves = k & 2;
        const machine m = follow(program(model, &options));
        CHECK_INT(m.arcs, 2);
        CHECK_INT(m.lines, 2);
        CHECK_NEAR(m.length, 160 + 20 * acos(-1), 1e-3);
        CHECK(m.worst <= 1.5e-4); /* each coordinate is rounded by half of 1e-4 */
        CHECK_NEAR(m.at[0], 10, 1e-9);
        CHECK_NEAR(m.at[1], 0, 1e-9);
        CHECK_NEAR(m.at[2], 5, 1e-9);
    }
    batten_model_unref(model);
}

TEST(depth_feed_and_decimals_are_as_asked)
{
    batten_model *model = model_of("hook (left)", hook());
    batten_write_gcode_options options = batten_write_gcode_defaults();
    options.depth = -1.5;
    options.feed = 300;
    options.decimals = 2;
    const char *text = program(model, &options);
    CHECK_CONTAINS(text, "G21 (millimetres)");
    CHECK_CONTAINS(text, "(hook _left_)");
    CHECK_CONTAINS(text, "G1 Z-1.50 F75.00");
    CHECK_CONTAINS(text, "G2 X");
    CHECK_CONTAINS(text, " F300.00");
    batten_model_unref(model);
}

TEST(inches_stay_inches_and_metres_become_millimetres)
{
    batten_model *model = model_of("hook", hook()), *other = NULL;
    CHECK_OK(batten_model_to_unit(model, 0.0254, &other));
    CHECK_CONTAINS(program(other, NULL), "G20 (inches)");
    batten_model_unref(other);
    CHECK_OK(batten_model_to_unit(model, 1, &other));
    CHECK_NEAR(follow(program(other, NULL)).length, 7.5 * acos(-1) + 4, 1e-3);
    batten_model_unref(other);
    batten_model_unref(model);
}

TEST(a_filleted_polyline_is_cut_as_lines_and_arcs_though_it_is_a_nurbs_curve)
{
    for (int raise = 0; raise < 3; raise++) {
        batten_model *model = model_of_curve(filleted(3, raise), NULL);
        const machine m = follow(program(model, NULL));
        CHECK_INT(m.arcs, 4);
        CHECK_INT(m.lines, 4);
        CHECK_NEAR(m.length, 260 - 80 + 20 * acos(-1), 1e-3);
        CHECK(m.worst <= 1.5e-4);
        CHECK_CONTAINS(program(model, NULL), "G1 Z3.0000");
        batten_model_unref(model);
    }
}

/* A chain of one arc of 100 with this rise in its middle. */
static batten_model *shallow(double rise)
{
    const double half = 2 * atan(rise / 50), radius = 50 / sin(half);
    const batten_span arc = {.kind = BATTEN_SPAN_ARC,
                             .length = 2 * half * radius,
                             .start = {3, 4},
                             .angle = 0.3 - half,
                             .curvature = {1 / radius}};
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &arc, NULL, false}, 0, &chain));
    return model_of("shallow", chain);
}

TEST(an_arc_that_the_decimals_do_not_show_is_a_line)
{
    const double rises[4] = {1e-200, 1e-18, 1e-9, 4e-5};
    for (int k = 0; k < 4; k++) {
        batten_model *model = shallow(rises[k]);
        const machine m = follow(program(model, NULL));
        CHECK_INT(m.arcs, 0);
        CHECK_INT(m.lines, 1);
        CHECK_NEAR(m.length, 100, 1e-3);
        batten_model_unref(model);
    }
}

/* The largest distance of the ends and middles of lines from a circle about (cx, cy). */
static double farthest(const char *text, double cx, double cy, double radius)
{
    double x = 3, y = 4, largest = 0;
    for (const char *line = strstr(text, "\nG1 X"); line; line = strstr(line + 1, "\nG1 X")) {
        double to[2];
        CHECK(sscanf(line, "\nG1 X%lf Y%lf", &to[0], &to[1]) == 2);
        const double middle = hypot((x + to[0]) / 2 - cx, (y + to[1]) / 2 - cy);
        largest = fmax(largest, fabs(middle - radius));
        largest = fmax(largest, fabs(hypot(to[0] - cx, to[1] - cy) - radius));
        x = to[0];
        y = to[1];
    }
    return largest;
}

TEST(an_arc_of_a_larger_radius_than_the_control_takes_is_lines_within_the_last_place)
{
    const double rise = 0.05, half = 2 * atan(rise / 50), radius = 50 / sin(half);
    const double cx = 3 - radius * sin(0.3 - half), cy = 4 + radius * cos(0.3 - half);
    batten_model *model = shallow(rise);
    batten_write_gcode_options options = batten_write_gcode_defaults();
    const machine lines = follow(program(model, NULL));
    CHECK_INT(lines.arcs, 0);
    CHECK_INT(lines.lines, 23); /* the root of 0.05 / 0.0001, and up */
    CHECK_NEAR(lines.length, 2 * half * radius, 1e-3);
    CHECK(farthest(program(model, NULL), cx, cy, radius) <= 1.8e-4);
    options.greatest_radius = 30e3;
    CHECK_INT(follow(program(model, &options)).arcs, 1);
    batten_model_unref(model);
    model = shallow(1);
    CHECK_INT(follow(program(model, NULL)).arcs, 1);
    options.greatest_radius = 100;
    options.decimals = 9;
    CHECK_INT(follow(program(model, &options)).arcs, 0);
    batten_model_unref(model);
}

/* The feed stands at the first cut and nowhere else, be it a line, an arc, or an arc as lines. */
TEST(the_feed_is_said_once_at_the_first_cut)
{
    const double rises[] = {1e-9, 0.05, 1};
    for (int k = 0; k < COUNT(rises); k++) {
        batten_model *model = shallow(rises[k]);
        const char *text = program(model, NULL), *down = strstr(text, "G1 Z");
        CHECK(down != NULL);
        const char *first = strchr(down, '\n') + 1, *feed = strstr(first, " F");
        CHECK(feed != NULL && feed < strchr(first, '\n'));
        CHECK(strncmp(feed, " F1000.0000\n", 12) == 0);
        CHECK(strstr(feed + 1, " F") == NULL);
        batten_model_unref(model);
    }
}

TEST(a_coordinate_that_no_machine_reaches_is_refused_with_a_cure)
{
    static const struct {
        double x;
        batten_status status;
    } cases[] = {{9.99e8, BATTEN_OK}, {-1e9, BATTEN_OVERFLOW}, {1e9, BATTEN_OVERFLOW}};
    for (int i = 0; i < COUNT(cases); i++) {
        const double points[] = {0, 0, 0, cases[i].x, 0, 0, cases[i].x, 2, 0};
        batten_curve *curve = NULL;
        batten_model *model = NULL;
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(batten_curve_polyline((batten_points){3, 3, points}, &curve));
        CHECK_OK(batten_model_create(0.001, &model));
        CHECK_OK(batten_model_add(
            model, &(batten_object){.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
        CHECK_STATUS(batten_write_gcode(model, NULL, NULL, &data, &size), cases[i].status);
        CHECK((data != NULL) == (cases[i].status == BATTEN_OK));
        if (cases[i].status != BATTEN_OK)
            CHECK_MESSAGE(
                "a coordinate of 1e+09 is more than controls take: look at the unit of "
                "the design, or scale and move what is cut");
        batten_release(data);
        batten_curve_unref(curve);
        batten_model_unref(model);
    }
}

TEST(too_many_lines_are_refused_with_a_cure)
{
    batten_chain *chain = hook(), *large = NULL;
    const batten_affine map = {{{1e7, 0, 0}, {0, 1e7, 0}, {0, 0, 1e7}}, {0, 0, 0}};
    CHECK_OK(batten_chain_transform(chain, &map, &large));
    batten_model *model = model_of("hook", large);
    batten_write_gcode_options options = batten_write_gcode_defaults();
    char *data = NULL;
    size_t size = 0;
    options.decimals = 9;
    CHECK_STATUS(batten_write_gcode(model, &options, NULL, &data, &size), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("hook: an arc from (0, 0)");
    CHECK_MESSAGE("allow a greater radius, or fewer decimals");
    batten_chain_unref(chain);
    batten_model_unref(model);
}

TEST(curves_that_are_no_paths_are_refused)
{
    batten_model *model = NULL;
    batten_curve *curve = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_curve_ellipse(2, 1, 0, 1, &curve));
    const batten_object object = {.name = "a", .kind = BATTEN_OBJECT_CURVE, .curve = curve};
    CHECK_OK(batten_model_add(model, &object));
    CHECK_STATUS(batten_write_gcode(model, NULL, NULL, &data, &size), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("chains of arcs");
    batten_curve_unref(curve);
    batten_model_unref(model);
}

/* A path is cut in any plane z = constant, also seen from below, and in no other. */
TEST(planes_that_lean_are_not_cut)
{
    static const struct {
        batten_frame frame;
        bool is_level;
    } cases[] = {{{{1, 2, 3}, {0.6, 0.8, 0}, {0, 0, 1}}, true},
                 {{{1, 2, 3}, {1, 0, 0}, {0, 0, -1}}, true},
                 {{{1, 2, 3}, {1, 0, 0}, {0, 0.6, 0.8}}, false},
                 {{{1, 2, 3}, {0, 1, 0}, {0.6, 0, 0.8}}, false},
                 {{{1, 2, 3}, {0.8, 0, -0.6}, {0.6, 0, 0.8}}, false}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_chain *flat = hook(), *turned = NULL;
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(batten_chain_place(flat, &cases[i].frame, &turned));
        batten_chain_unref(flat);
        batten_model *model = model_of("hook", turned);
        CHECK_STATUS(batten_write_gcode(model, NULL, NULL, &data, &size),
                     cases[i].is_level ? BATTEN_OK : BATTEN_UNSUPPORTED);
        CHECK((data != NULL) == cases[i].is_level);
        batten_release(data);
        batten_model_unref(model);
    }
}
