/* Borders made by hand: their triangles, and what must be finer where they are not simple. */
#include "mesh/faces/rim_scene.h"

static bool make_triangles(border *b, bat_sides *sides)
{
    bool is_simple = false;
    CHECK_OK(bat_rim_triangles(&b->rim, &b->lattice, sides, &b->splits, &is_simple));
    if (!is_simple)
        CHECK(!sides->triangles && !sides->at);
    return is_simple;
}

static bool has_split(const border *b, int edge, int segment)
{
    return bat_pairs_find(&b->splits, edge, segment) >= 0;
}

/* The area of the triangles inside. */
static double inner_area(const bat_sides *s)
{
    double all = 0;
    for (int t = 0; t < s->count; t++) {
        const double *a = s->at[s->triangles[t].corner[0]],
                     *b = s->at[s->triangles[t].corner[1]],
                     *c = s->at[s->triangles[t].corner[2]];
        if (s->triangles[t].inside)
            all += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
    return all;
}

static const double square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
static const double hole[4][2] = {{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.75}, {0.75, 0.25}};

TEST(the_triangles_of_a_simple_border_fill_it)
{
    border *b = begin_border();
    bat_sides sides;
    batten_interval box[2];
    add_polygon(b, 3, 4, square);
    add_polygon(b, 4, 4, hole);
    CHECK(make_triangles(b, &sides));
    CHECK_NEAR(inner_area(&sides), 0.75, 1e-15);
    CHECK_INT(b->splits.count, 0);
    bat_rim_box(&b->rim, box);
    CHECK(box[0].a == 0 && box[0].b == 1 && box[1].a == 0 && box[1].b == 1);
    bat_sides_end(&sides);
    bat_pairs_end(&b->splits);
}

TEST(the_box_of_a_border_holds_its_corners_and_that_of_none_is_at_zero)
{
    static const double away[3][2] = {{-5, -4}, {-3, -7}, {-2, -6}};
    border *b = begin_border();
    batten_interval box[2] = {{9, 9}, {9, 9}};
    bat_rim_box(&b->rim, box);
    CHECK(box[0].a == 0 && box[0].b == 0 && box[1].a == 0 && box[1].b == 0);
    add_polygon(b, 0, 3, away);
    bat_rim_box(&b->rim, box);
    CHECK(box[0].a == -5 && box[0].b == -2 && box[1].a == -7 && box[1].b == -4);
    bat_pairs_end(&b->splits);
}

TEST(sides_that_cross_must_be_finer_and_others_need_not)
{
    /* A bow tie: the second side crosses the fourth. */
    static const double bow[4][2] = {{0, 0}, {1, 0}, {0.25, 1}, {0.75, 1}};
    border *b = begin_border();
    bat_sides sides;
    add_polygon(b, 7, 4, bow);
    CHECK(!make_triangles(b, &sides));
    CHECK_INT(b->splits.count, 2);
    CHECK(has_split(b, 7, 1) && has_split(b, 7, 3));
    bat_pairs_end(&b->splits);
}

TEST(a_side_that_a_corner_touches_must_be_finer_and_so_must_those_at_the_corner)
{
    static const double touching[3][2] = {{0.5, 0}, {0.75, 0.5}, {0.25, 0.5}};
    border *b = begin_border();
    bat_sides sides;
    add_polygon(b, 0, 4, square);
    add_polygon(b, 1, 3, touching);
    CHECK(!make_triangles(b, &sides));
    CHECK_INT(b->splits.count, 3);
    CHECK(has_split(b, 0, 0) && has_split(b, 1, 0) && has_split(b, 1, 2));
    bat_pairs_end(&b->splits);
}

TEST(corners_at_one_place_must_be_one_vertex)
{
    static const double other[3][2] = {{0, 0}, {0.5, 0.25}, {0.25, 0.5}};
    for (int is_same = 0; is_same < 2; is_same++) {
        border *b = begin_border();
        bat_sides sides;
        add_polygon(b, 0, 4, square);
        add_polygon(b, 1, 3, other);
        b->corners[4].vertex = is_same ? b->corners[0].vertex : b->corners[4].vertex;
        CHECK_INT(make_triangles(b, &sides), is_same);
        CHECK_INT(b->splits.count, is_same ? 0 : 4);
        if (is_same) {
            CHECK_INT(b->vertex_of[0], b->vertex_of[4]);
            bat_sides_end(&sides);
        } else {
            CHECK(has_split(b, 0, 0) && has_split(b, 0, 3));
            CHECK(has_split(b, 1, 0) && has_split(b, 1, 2));
        }
        bat_pairs_end(&b->splits);
    }
}

TEST(a_border_on_one_line_must_be_finer_everywhere_but_at_poles)
{
    static const double flat[4][2] = {{0, 0}, {0.25, 0}, {0.5, 0}, {1, 0}};
    border *b = begin_border();
    bat_sides sides = {0};
    add_polygon(b, 2, 4, flat);
    b->corners[1].edge = -1; /* along a pole */
    CHECK(!make_triangles(b, &sides));
    CHECK_INT(b->splits.count, 3);
    CHECK(!has_split(b, 2, 1) && !has_split(b, -1, 1));
    bat_pairs_clear(&b->splits);
    CHECK_OK(bat_rim_refine_all(&b->rim, &b->splits));
    CHECK_INT(b->splits.count, 3);
    bat_pairs_end(&b->splits);
}

TEST(the_sides_between_given_vertices_are_refined)
{
    border *b = begin_border();
    bat_sides sides;
    bat_pairs between;
    int index;
    add_polygon(b, 5, 4, square);
    CHECK(make_triangles(b, &sides));
    CHECK_OK(bat_pairs_begin(&between, 4));
    CHECK_OK(bat_rim_refine(&b->rim, &between, &b->splits));
    CHECK_INT(b->splits.count, 0);
    for (int i = 1; i < 4; i += 2) {
        const int p = b->vertex_of[i], q = b->vertex_of[(i + 1) % 4];
        CHECK_OK(bat_pairs_add(&between, p < q ? p : q, p < q ? q : p, &index));
    }
    CHECK_OK(bat_rim_refine(&b->rim, &between, &b->splits));
    CHECK_INT(b->splits.count, 2);
    CHECK(has_split(b, 5, 1) && has_split(b, 5, 3));
    bat_sides_end(&sides);
    bat_pairs_end(&between);
    bat_pairs_end(&b->splits);
}
