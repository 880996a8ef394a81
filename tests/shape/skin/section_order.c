/* Sections that do not go together: kinds, crossings, disorder. */
#include "shape/sections.h"
#include "shape/skin/steps.h"

#include <batten/standard.h>

enum { MOST = 5 };

/* A line from (0, a, z) to (4, b, z). */
static batten_curve *line(double a, double b, double z)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_line(3, (double[]){0, a, z}, (double[]){4, b, z}, &curve));
    return curve;
}

static batten_surface_skin_report order_of(int count, batten_curve **sections, bool closed)
{
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.closed = closed;
    bool point[MOST] = {false};
    bat_skin t = {.count = count, .options = &options, .unified = sections, .point = point};
    CHECK_OK(bat_skin_order(&t));
    return t.found;
}

/* Heights of level lines, and the first that rather follows its successor. */
static const struct {
    int count;
    double heights[MOST];
    bool closed;
    int disorder, disorder_count;
    const char *message;
} orders[] = {
    {4, {0, 1, 2, 3}, false, -1, 0, NULL},
    {4, {0, 2, 1, 3}, false, 1, 1, "sections 2 and 3 are rather in the other order"},
    {4, {0, 2, 1, 3}, true, -1, 0, NULL},
    {3, {1, 0, 3}, false, 0, 1, "sections 1 and 2 are rather in the other order"},
    {3, {0, 3, 2}, false, 1, 1, "sections 2 and 3 are rather in the other order"},
    {2, {1, 0}, false, -1, 0, NULL},
    /* 3 - d is less than 0.9 (3 + d) from d = 0.1579 on. */
    {4, {0, 1.578, 1.422, 3}, false, -1, 0, NULL},
    {4, {0, 1.58, 1.42, 3}, false, 1, 1, NULL},
};

TEST(neighbours_that_make_the_way_a_tenth_longer_are_in_disorder)
{
    for (int i = 0; i < COUNT(orders); i++) {
        batten_curve *sections[MOST];
        for (int k = 0; k < orders[i].count; k++)
            sections[k] = line(0, 0, orders[i].heights[k]);
        const batten_surface_skin_report found =
            order_of(orders[i].count, sections, orders[i].closed);
        CHECK_INT(found.disorder, orders[i].disorder);
        CHECK_INT(found.disorder_count, orders[i].disorder_count);
        CHECK_INT(found.crossing, -1);
        CHECK_INT(found.crossing_count, 0);
        if (orders[i].message)
            CHECK_MESSAGE(orders[i].message);
        unref_all(orders[i].count, sections);
    }
}

/* Lines that change sides, in one plane or lifted: of 33 places that at 14 is 0.025 before the crossing and the next
 * 0.0375 behind it, so that the step turns by 120 degrees where it is lifted by 0.0175. */
static const struct {
    double a, b, z;
    bool crosses;
} second_lines[] = {
    {-1, 1, 0, true},          {1, -1, 0, true},   {-0.9, 1.1, 0.0177, false},
    {-0.9, 1.1, 0.0174, true}, {1, 1, 0, false},   {0, 1, 0, false},
    {0, 0, 0, false},          {-0.1, 1, 0, true}, {-1, 0, 0, false},
    {-1, 0.1, 0, true},
};

TEST(sections_cross_where_the_step_from_one_to_the_next_turns_back_at_once)
{
    for (int i = 0; i < COUNT(second_lines); i++) {
        /* The pair comes second. */
        batten_curve *sections[3] = {
            line(0, 0, -5), line(0, 0, 0),
            line(second_lines[i].a, second_lines[i].b, second_lines[i].z)};
        const batten_surface_skin_report found = order_of(3, sections, false);
        CHECK_INT(found.crossing_count, second_lines[i].crosses);
        CHECK_INT(found.crossing, second_lines[i].crosses ? 1 : -1);
        if (second_lines[i].crosses && found.disorder < 0)
            CHECK_MESSAGE("sections 2 and 3 cross");
        unref_all(3, sections);
    }
}

/* 'o' open, 'c' closed, 'p' a point. */
static batten_curve *section_of_kind(char kind)
{
    static const double square[5][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
    static const double point[2][3] = {{3, 4, 5}, {3, 4, 5}}, knots[4] = {0, 0, 1, 1};
    batten_curve *curve = NULL;
    if (kind == 'p')
        CHECK_OK(batten_curve_create((batten_points){3, 2, point[0]}, 1, NULL, knots, &curve));
    else
        CHECK_OK(
            batten_curve_polyline((batten_points){3, kind == 'c' ? 5 : 4, square[0]}, &curve));
    return curve;
}

static const struct {
    const char *kinds;
    bool mixed, closed;
    const char *refused;
} mixtures[] = {
    {"ooo", false, false, NULL},
    {"ccc", false, true, NULL},
    {"pcp", false, true, NULL},
    {"pop", false, false, NULL},
    {"ppp", false, false, NULL},
    {"pco", false, false, "section 2 is closed, and section 3 is open: closed and open"},
    {"ocp", false, false, "section 1 is open, and section 2 is closed: closed and open"},
    {"coc", true, false, NULL},
    {"occ", true, false, NULL},
    {"ccp", true, true, NULL},
};

TEST(sections_are_all_open_or_all_closed_but_for_points)
{
    for (int i = 0; i < COUNT(mixtures); i++) {
        batten_curve *sections[3];
        bool point[3] = {false, false, false};
        for (int k = 0; k < 3; k++)
            sections[k] = section_of_kind(mixtures[i].kinds[k]);
        bat_skin t = {
            .count = 3, .placed = sections, .point = point, .mixed = mixtures[i].mixed};
        CHECK_STATUS(bat_skin_kinds(&t),
                     mixtures[i].refused ? BATTEN_NOT_COMPATIBLE : BATTEN_OK);
        if (mixtures[i].refused)
            CHECK_MESSAGE(mixtures[i].refused);
        else
            CHECK_INT(t.closed, mixtures[i].closed);
        for (int k = 0; k < 3 && !mixtures[i].refused; k++)
            CHECK_INT(point[k], mixtures[i].kinds[k] == 'p');
        unref_all(3, sections);
    }
}

/* A point far up or down, whose control points zigzag by their last digits, as those that were fitted to few knots with
 * their neighbours. */
static batten_curve *tip_of_roundings(double z)
{
    enum { POINTS = 9 };
    double points[POINTS][3], knots[POINTS + 2];
    for (int i = 0; i < POINTS; i++) {
        points[i][0] = 3e-15 * i;
        points[i][1] = 0;
        points[i][2] = i % 2 ? nextafter(z, 0) : z;
        knots[i + 1] = i / (POINTS - 1.0);
    }
    knots[0] = 0;
    knots[POINTS + 1] = 1;
    batten_curve *tip = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, POINTS, points[0]}, 1, NULL, knots, &tip));
    return tip;
}

TEST(lines_to_and_from_a_tip_do_not_cross)
{
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_curve *sections[3] = {tip_of_roundings(-100), line(-1, 1, 0), tip_of_roundings(100)};
    bool point[3] = {true, false, true};
    bat_skin t = {.count = 3, .options = &options, .unified = sections, .point = point};
    CHECK_OK(bat_skin_order(&t));
    CHECK(t.found.crossing == -1 && t.found.crossing_count == 0);
    CHECK(t.found.disorder == -1 && t.found.disorder_count == 0);
    for (int k = 0; k < 3; k++)
        batten_curve_unref(sections[k]);
}
