/* The chords of a polygon, its turns, and circles and spans in their frame. */
#include "shape/points/chord_polygon.h"
#include "support/test.h"

static const double pi = 3.14159265358979323846;

/* What failed is ended, so that a test may try again. */
static batten_status make_polygon(int count, const double *points, bool closed,
                                  bat_chord_polygon *out)
{
    const batten_status status = bat_chord_polygon_make(count, points, closed, out);
    if (status != BATTEN_OK) {
        bat_chord_polygon_end(out);
        *out = (bat_chord_polygon){0};
    }
    return status;
}

TEST(the_turns_of_a_regular_polygon_add_up_to_the_turns_it_makes)
{
    for (int n = 3; n < 9; n++)
        for (int winding = 1; 2 * winding < n; winding++)
            for (int side = -1; side < 2; side += 2) {
                double points[16], angles[8] = {0}, directions[8];
                for (int i = 0; i < n; i++) {
                    points[2 * i] = 3 * cos(2 * pi * i * winding / n);
                    points[2 * i + 1] = 3 * side * sin(2 * pi * i * winding / n);
                }
                bat_chord_polygon c;
                CHECK_OK(make_polygon(n, points, true, &c));
                CHECK_INT(c.spans, n);
                CHECK_NEAR(c.unit, 6 * sin(pi * winding / n), 1e-14);
                CHECK_NEAR(c.size, 3, 0);
                for (int i = 0; i < n; i++) {
                    CHECK_NEAR(c.turn[i], side * 2 * pi * winding / n, 1e-13);
                    CHECK_NEAR(c.length[i], 1, 1e-14);
                    CHECK_OK(bat_chord_polygon_check_turn(&c, i));
                }
                angles[1] = 0.25;
                bat_chord_polygon_directions(&c, angles, directions);
                for (int i = 0; i < n; i++)
                    CHECK_NEAR(directions[i] - angles[i] - directions[0],
                               side * 2 * pi * winding * i / n, 1e-12);
                bat_chord_polygon_end(&c);
            }
}

TEST(an_open_polygon_does_not_turn_at_its_ends_and_its_sharpest_turn_is_found)
{
    const double points[] = {0, 0, 4, 0, 4, 2, 3, 1, 3, 9};
    const double expected[] = {0, pi / 2, 3 * pi / 4, -3 * pi / 4, 0};
    bat_chord_polygon c;
    int at = -1;
    CHECK_OK(make_polygon(5, points, false, &c));
    CHECK_INT(c.spans, 4);
    for (int i = 0; i < 5; i++)
        CHECK_NEAR(c.turn[i], expected[i], 1e-14);
    CHECK_NEAR(c.length[0], 0.5, 0);
    CHECK_NEAR(c.length[3], 1, 0);
    c.turn[3] = -2.5;
    CHECK_NEAR(bat_chord_polygon_sharpest(&c, &at), 2.5, 0);
    CHECK_INT(at, 3);
    /* The last point has the direction of the chord that ends there. */
    const double angles[5] = {0, 0, 0, 0, 0.5};
    double directions[5];
    c.turn[3] = expected[3];
    bat_chord_polygon_directions(&c, angles, directions);
    CHECK_NEAR(directions[3], pi / 2, 1e-14);
    CHECK_NEAR(directions[4], pi / 2 + 0.5, 1e-14);
    bat_chord_polygon_end(&c);
    const double straight[] = {0, 0, 1, 0, 2, 0};
    CHECK_OK(make_polygon(3, straight, false, &c));
    CHECK_NEAR(bat_chord_polygon_sharpest(&c, &at), 0, 0);
    CHECK_INT(at, 0);
    bat_chord_polygon_end(&c);
}

TEST(a_polygon_that_turns_back_on_itself_is_refused_at_that_point)
{
    for (int k = 0; k < 2; k++) {
        const double points[] = {0, 0, 3, 0, 1, k * 1e-9, 1, 5};
        bat_chord_polygon c;
        CHECK_OK(make_polygon(4, points, false, &c));
        CHECK_OK(bat_chord_polygon_check_turn(&c, 2));
        CHECK_STATUS(bat_chord_polygon_check_turn(&c, 1), k ? BATTEN_OK : BATTEN_SINGULAR_HERE);
        if (!k)
            CHECK_MESSAGE("point 2");
        bat_chord_polygon_end(&c);
    }
    /* Far from the origin coordinates are rounded: a back turn within that is one. */
    const double far[] = {1e9, 1e9, 1e9 + 3, 1e9, 1e9 + 1, 1e9 + 2.4e-7};
    bat_chord_polygon c;
    CHECK_OK(make_polygon(3, far, false, &c));
    CHECK_STATUS(bat_chord_polygon_check_turn(&c, 1), BATTEN_SINGULAR_HERE);
    bat_chord_polygon_end(&c);
}

TEST(chords_without_length_or_beyond_numbers_are_named)
{
    const double same[] = {0, 0, 1, 1, 2, 0, 0, 0}, huge[] = {-1e308, 0, 1e308, 1e308, 0, 1};
    bat_chord_polygon c;
    CHECK_OK(make_polygon(4, same, false, &c));
    bat_chord_polygon_end(&c);
    CHECK_STATUS(make_polygon(4, same, true, &c), BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 4 and 1");
    bat_chord_polygon_end(&c);
    CHECK_STATUS(make_polygon(3, huge, false, &c), BATTEN_OVERFLOW);
    CHECK_MESSAGE("points 1 and 2");
    bat_chord_polygon_end(&c);
}

TEST(the_circle_through_three_points_has_its_tangent_across_the_radius)
{
    test_random random = test_random_begin("circle angle");
    for (int n = 0; n < 100; n++) {
        const double a = test_random_in(&random, 0, 2), b = a + test_random_in(&random, 0.1, 2);
        const double c = b + test_random_in(&random, 0.1, 2);
        /* Points at these angles of the unit circle: a chord is 2 sin of half the arc, and stands
         * to the tangent at its end by half the arc. */
        const double before = 2 * sin((b - a) / 2), after = 2 * sin((c - b) / 2);
        CHECK_NEAR(bat_circle_angle(before, after, (c - a) / 2), -(c - b) / 2, 1e-13);
        CHECK_NEAR(bat_circle_angle(before, after, -(c - a) / 2), (c - b) / 2, 1e-13);
    }
    CHECK_NEAR(bat_circle_angle(2, 3, 0), 0, 0);
}

TEST(a_span_is_turned_with_its_chord_and_moved_to_its_point)
{
    const double chord[] = {3, 4}, point[] = {10, 20};
    const double turn = atan2(4, 3);
    batten_span span = {.kind = BATTEN_SPAN_TENSION,
                        .start = {1, 0},
                        .end = {6, 5},
                        .bend = {{5, 0}, {0, 10}},
                        .angle = 1,
                        .chord = 2};
    bat_chord_put(chord, point, &span);
    CHECK_NEAR(span.start[0], 10.6, 1e-14);
    CHECK_NEAR(span.start[1], 20.8, 1e-14);
    CHECK_NEAR(span.end[0], 10 + 3.6 - 4, 1e-14);
    CHECK_NEAR(span.end[1], 20 + 4.8 + 3, 1e-14);
    CHECK_NEAR(span.bend[0][0], 3, 1e-14);
    CHECK_NEAR(span.bend[0][1], 4, 1e-14);
    CHECK_NEAR(span.bend[1][0], -8, 1e-14);
    CHECK_NEAR(span.bend[1][1], 6, 1e-14);
    CHECK(span.angle == 0 && span.chord == 0);
    batten_span geometric = {.kind = BATTEN_SPAN_GEOMETRIC, .angle = 0.5, .chord = 0.25};
    bat_chord_put(chord, point, &geometric);
    CHECK_NEAR(geometric.angle, 0.5 + turn, 1e-15);
    CHECK_NEAR(geometric.chord, 0.25 + turn, 1e-15);
    CHECK(geometric.end[0] == 0 && geometric.end[1] == 0 && geometric.start[0] == 10);
    batten_span arc = {.kind = BATTEN_SPAN_ARC, .angle = 0.5, .chord = 0.25, .end = {1, 1}};
    bat_chord_put(chord, point, &arc);
    CHECK_NEAR(arc.angle, 0.5 + turn, 1e-15);
    CHECK(arc.chord == 0 && arc.end[0] == 0 && arc.end[1] == 0);
}
