/* Points put between sides: taken where they may be, and Delaunay afterwards. */
#include "mesh/faces/side_scene.h"

#include <math.h>

static bool is_vertex(const scene *c, long long x, long long y)
{
    for (int v = 0; v < c->triangles.vertex_count; v++)
        if (scene_whole(c, v, 0) == x && scene_whole(c, v, 1) == y)
            return true;
    return false;
}

/* The new triangles are those around the vertex: inside, to be looked at again, younger than before. */
static void check_new(const scene *c, int vertex)
{
    int around = 0;
    for (int t = 0; t < c->triangles.count; t++) {
        const bat_side_triangle *here = &c->triangles.triangles[t];
        if (here->corner[0] != vertex && here->corner[1] != vertex && here->corner[2] != vertex)
            continue;
        around++;
        CHECK(here->inside && !here->done && here->born > 0);
    }
    CHECK(around >= 3);
}

TEST(points_inside_are_put_in_and_all_others_are_not)
{
    test_random random = test_random_begin("points");
    for (int round = 0; round < test_cases(8); round++) {
        scene *c = scene_rings(&random, 12 + round);
        const long long hull = scene_check(c), inner = scene_check_inside(c);
        int taken = 0;
        for (int i = 0; i < 120; i++) {
            const int x = test_random_int(&random, 0, UNIT),
                      y = test_random_int(&random, 0, UNIT);
            const double point[2] = {(double)x / UNIT, (double)y / UNIT};
            bool is_on;
            const bool inside = scene_is_inside(c, 3LL * x, 3LL * y, &is_on);
            const bool should = inside && !is_on && !is_vertex(c, x, y);
            int vertex = -7;
            CHECK_OK(bat_sides_insert(&c->triangles, point, -1, 0, &vertex));
            CHECK_INT(vertex, should ? c->triangles.vertex_count - 1 : -1);
            CHECK(c->triangles.near[0] == -1 && c->triangles.near[1] == -1);
            if (!should)
                continue;
            taken++;
            CHECK(scene_whole(c, vertex, 0) == x && scene_whole(c, vertex, 1) == y);
            check_new(c, vertex);
        }
        CHECK(taken > 20);
        CHECK_INT(scene_check(c), hull);
        CHECK_INT(scene_check_inside(c), inner);
        scene_check_delaunay(c);
        CHECK(c->triangles.steps >= 120);
        bat_sides_end(&c->triangles);
    }
}

/* Seen from the vertex: the cosine between the ends of the side, and the nearer end in parts of its length. */
static void see_side(const double *p, const double *a, const double *b, double *cosine,
                     double *nearest)
{
    const double to_a = hypot(a[0] - p[0], a[1] - p[1]), to_b = hypot(b[0] - p[0], b[1] - p[1]);
    *cosine = ((a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1])) / (to_a * to_b);
    *nearest = fmin(to_a, to_b) / hypot(b[0] - a[0], b[1] - a[1]);
}

TEST(points_near_a_side_are_not_put_in_and_the_side_is_named)
{
    enum { WIDEST_BY_TENTHS = 2 };
    const double widest = -0.1 * WIDEST_BY_TENTHS, least = 0.25, room = 1e-12;
    test_random random = test_random_begin("near sides");
    int refused_by_angle = 0, refused_by_end = 0, taken = 0;
    for (int round = 0; round < test_cases(8); round++) {
        scene *c = scene_rings(&random, 16);
        for (int i = 0; i < 150; i++) {
            const double point[2] = {test_random_int(&random, 0, UNIT) / (double)UNIT,
                                     test_random_int(&random, 0, UNIT) / (double)UNIT};
            const int before = c->triangles.vertex_count;
            int vertex;
            double cosine, nearest;
            CHECK_OK(bat_sides_insert(&c->triangles, point, widest, least, &vertex));
            CHECK_INT(c->triangles.vertex_count, before + (vertex >= 0));
            const bat_sides *s = &c->triangles;
            if (vertex < 0 && s->near[0] >= 0) {
                CHECK(scene_has_side(c, s->near[0], s->near[1]));
                see_side(point, s->at[s->near[0]], s->at[s->near[1]], &cosine, &nearest);
                CHECK(cosine < widest + room || nearest < least + room);
                refused_by_angle += cosine < widest;
                refused_by_end += nearest < least;
            }
            for (int t = 0; vertex >= 0 && t < s->count; t++) {
                const bat_side_triangle *here = &s->triangles[t];
                if (here->corner[0] != vertex || !(here->fixed & 1))
                    continue;
                see_side(point, s->at[here->corner[1]], s->at[here->corner[2]], &cosine,
                         &nearest);
                CHECK(cosine >= widest - room && nearest >= least - room);
                taken++;
            }
        }
        scene_check(c);
        scene_check_delaunay(c);
        bat_sides_end(&c->triangles);
    }
    CHECK(refused_by_angle > 0 && refused_by_end > 0 && taken > 0);
}

TEST(a_point_in_the_circles_of_many_triangles_sees_all_their_corners)
{
    enum { CORNERS = 60 };
    scene *c = test_array(1, sizeof *c);
    const double middle[2] = {0.5, 0.5};
    int vertex, around = 0;
    for (int i = 0; i < CORNERS; i++) {
        const double angle = 2 * acos(-1) / CORNERS * i;
        scene_point(c, CENTRE + (int)lrint(62 * cos(angle)),
                    CENTRE + (int)lrint(62 * sin(angle)));
    }
    scene_begin(c);
    scene_keep_star(c, 0, CORNERS);
    CHECK_OK(bat_sides_settle(&c->triangles));
    CHECK_OK(bat_sides_insert(&c->triangles, middle, -1, 0, &vertex));
    CHECK_INT(vertex, CORNERS);
    CHECK_INT(c->triangles.count, CORNERS);
    for (int t = 0; t < CORNERS; t++)
        around += c->triangles.triangles[t].corner[0] == vertex;
    CHECK(around > 40);
    scene_check(c);
    bat_sides_end(&c->triangles);
}
