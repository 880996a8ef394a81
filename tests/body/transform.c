/* Bodies under affine maps: places exactly, outside stays outside, all else as it was. */
#include "support/bodies.h"
#include "support/test.h"

#include <batten/standard.h>

static const batten_affine maps[] = {
    {{{2, 0.5, 0.3}, {-0.4, 1, 0.2}, {0.1, 0.6, 3}}, {10, 20, 30}},
    {{{0, 2, 0}, {1, 0, 0}, {0.3, 0.1, 1}}, {-1, 0, 5}}, /* x and y change places: a mirror */
    {{{-1, 0, 0.2}, {0, -1, 0}, {0, 0, -4}}, {0, 0, 0}},
};

static double determinant(const batten_affine *map)
{
    const double(*m)[3] = map->m;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

static void check_point(const batten_affine *map, const double *from, const double *to)
{
    for (int c = 0; c < 3; c++)
        CHECK_NEAR(to[c],
                   map->m[c][0] * from[0] + map->m[c][1] * from[1] + map->m[c][2] * from[2] +
                       map->t[c],
                   1e-13);
}

TEST(vertices_and_curves_move_by_the_map_and_the_body_stays_a_solid)
{
    batten_body *body = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3});
    const batten_body_parts *was = batten_body_view(body);
    for (int m = 0; m < COUNT(maps); m++) {
        const batten_affine *map = &maps[m];
        batten_body *made = NULL;
        batten_body_measures measures;
        double squares = 0;
        CHECK_OK(batten_body_transform(body, map, &made));
        const batten_body_parts *p = batten_body_view(made);
        for (int i = 0; i < 8; i++)
            check_point(map, was->vertices + 3 * i, p->vertices + 3 * i);
        for (int i = 0; i < 12; i++) {
            double from[3], to[3];
            CHECK_OK(batten_curve_evaluate(was->edges[i].curve, 0.25, 0, from));
            CHECK_OK(batten_curve_evaluate(p->edges[i].curve, 0.25, 0, to));
            check_point(map, from, to);
        }
        for (int f = 0; f < 6; f++) {
            CHECK_TEXT(p->faces[f].name, was->faces[f].name);
            CHECK_INT(p->faces[f].reversed, was->faces[f].reversed != (determinant(map) < 0));
        }
        CHECK(p->is_solid && p->shells[0].closed);
        for (int i = 0; i < 9; i++)
            squares += map->m[i / 3][i % 3] * map->m[i / 3][i % 3];
        CHECK_NEAR(p->tolerance, was->tolerance * sqrt(squares / 3), 1e-20);
        CHECK_OK(batten_body_measure(made, 1e-9, NULL, &measures));
        CHECK_NEAR(measures.volume, 6 * fabs(determinant(map)), 1e-9);
        check_point(map, (const double[]){0.5, 1, 1.5}, measures.centroid);
        batten_body_unref(made);
    }
    batten_body_unref(body);
}

TEST(maps_that_are_singular_or_not_finite_are_refused)
{
    batten_body *body = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3}), *made = NULL;
    batten_affine bad[3] = {maps[0], maps[0], maps[0]};
    memcpy(bad[0].m[2], bad[0].m[1], sizeof bad[0].m[2]);
    bad[1].m[1][2] = NAN;
    bad[2].m[0][0] = INFINITY;
    for (int i = 0; i < 3; i++) {
        CHECK_STATUS(batten_body_transform(body, &bad[i], &made), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("the map is singular or not finite");
    }
    CHECK(!made);
    batten_body_unref(body);
}
