#include "exchange/meshes/facets.h"

#include <float.h>

#include "exchange/meshes/meshes.h"

/* ---- normals ---- */

TEST(a_normal_is_the_unit_cross_product_whatever_the_size_of_the_triangle)
{
    /* (1, 2, 3) x (4, 5, 6) = (-3, 6, -3) */
    static const double sizes[] = {1, 1e-300, 1e300, 3};
    for (int i = 0; i < COUNT(sizes); i++) {
        const double s = sizes[i], r = 1 / sqrt(6);
        double n[3];
        bat_facet_normal((const double[]){s, s, s}, (const double[]){2 * s, 3 * s, 4 * s},
                         (const double[]){5 * s, 6 * s, 7 * s}, n);
        CHECK_NEAR(n[0], -r, 4e-16);
        CHECK_NEAR(n[1], 2 * r, 4e-16);
        CHECK_NEAR(n[2], -r, 4e-16);
    }
}

TEST(corners_at_opposite_ends_of_the_doubles_have_a_normal)
{
    const double m = DBL_MAX;
    double n[3];
    bat_facet_normal((const double[]){-m, -m, 0}, (const double[]){m, -m, 0},
                     (const double[]){-m, m, 0}, n);
    CHECK_BITS(n[0], 0);
    CHECK_BITS(n[1], 0);
    CHECK_BITS(n[2], 1);
}

TEST(a_triangle_without_area_has_no_normal)
{
    static const double corners[][9] = {{1, 2, 3, 1, 2, 3, 1, 2, 3},
                                        {0, 0, 0, 1, 1, 1, 2, 2, 2}};
    for (int i = 0; i < COUNT(corners); i++) {
        double n[3] = {7, 7, 7};
        bat_facet_normal(corners[i], corners[i] + 3, corners[i] + 6, n);
        for (int k = 0; k < 3; k++)
            CHECK_BITS(n[k], 0);
    }
}

/* ---- polygons ---- */

enum { MOST = 140 };

static void area_of(const double *a, const double *b, const double *c, double sum[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        sum[k] += (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    }
}

/* The triangles cover a plane polygon once: all are turned as it is, and their areas add up to
 * its own. Each corner is used. */
static void check_covers(int count, const double *points)
{
    int triangles[3 * MOST], used[MOST] = {0};
    double whole[3] = {0, 0, 0}, sum[3] = {0, 0, 0}, parts = 0;
    bool is_odd = true;
    bat_polygon_triangles(count, points, triangles, &is_odd);
    CHECK(!is_odd);
    for (int i = 1; i + 1 < count; i++)
        area_of(points, points + 3 * i, points + 3 * (i + 1), whole);
    for (int i = 0; i < count - 2; i++) {
        double one[3] = {0, 0, 0};
        const int *t = triangles + 3 * i;
        for (int k = 0; k < 3; k++) {
            CHECK(t[k] >= 0 && t[k] < count);
            used[t[k]] = 1;
        }
        area_of(points + 3 * t[0], points + 3 * t[1], points + 3 * t[2], one);
        CHECK(one[0] * whole[0] + one[1] * whole[1] + one[2] * whole[2] > 0);
        parts += sqrt(one[0] * one[0] + one[1] * one[1] + one[2] * one[2]);
        for (int k = 0; k < 3; k++)
            sum[k] += one[k];
    }
    const double area = sqrt(whole[0] * whole[0] + whole[1] * whole[1] + whole[2] * whole[2]);
    CHECK_NEAR(parts, area, 1e-12 * area);
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(sum[k], whole[k], 1e-12 * area);
    for (int i = 0; i < count; i++)
        CHECK(used[i]);
}

/* A plane polygon, moved into a plane of space; reversed and begun at each corner. */
static void check_everywhere(int count, const double (*xy)[2])
{
    static const double frames[][6] = {{1, 0, 0, 0, 1, 0},     {0, 1, 0, 0, 0, 1},
                                       {0, 0, 1, 1, 0, 0},     {0, 1, 0, 1, 0, 0},
                                       {0.6, 0.8, 0, 0, 0, 1}, {0, 0.6, -0.8, 1, 0, 0}};
    for (int f = 0; f < COUNT(frames); f++)
        for (int first = 0; first < count; first++)
            for (int turned = 0; turned < 2; turned++) {
                double points[3 * MOST];
                for (int i = 0; i < count; i++) {
                    const double *p =
                        xy[turned ? (first + count - i) % count : (first + i) % count];
                    for (int k = 0; k < 3; k++)
                        points[3 * i + k] =
                            frames[f][k] * p[0] + frames[f][3 + k] * p[1] + 5 * k;
                }
                check_covers(count, points);
            }
}

TEST(convex_polygons_are_covered_once_by_a_fan)
{
    double xy[12][2];
    for (int i = 0; i < 12; i++) {
        xy[i][0] = 3 * cos(i * 0.5235987755982988);
        xy[i][1] = sin(i * 0.5235987755982988);
    }
    check_everywhere(12, (const double(*)[2])xy);
}

TEST(polygons_with_bays_are_covered_once_wherever_they_begin)
{
    static const double arrow[][2] = {{0, 0}, {4, 2}, {0, 4}, {1, 2}};
    static const double comb[][2] = {{0, 0}, {7, 0}, {7, 3}, {6, 3}, {6, 1}, {4, 1},
                                     {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    static const double spiral[][2] = {{0, 0}, {6, 0}, {6, 6}, {1, 6}, {1, 2}, {4, 2}, {4, 4},
                                       {3, 4}, {3, 3}, {2, 3}, {2, 5}, {5, 5}, {5, 1}, {0, 1}};
    check_everywhere(COUNT(arrow), arrow);
    check_everywhere(COUNT(comb), comb);
    check_everywhere(COUNT(spiral), spiral);
}

TEST(random_polygons_like_stars_are_covered_once)
{
    test_random random = test_random_begin(__func__);
    for (int n = 0; n < test_cases(40); n++) {
        const int count = test_random_int(&random, 4, 30);
        double points[3 * MOST];
        for (int i = 0; i < count; i++) {
            const double r = test_random_in(&random, 0.2, 2), a = 6.283185307179586 * i / count;
            points[3 * i] = r * cos(a);
            points[3 * i + 1] = r * sin(a);
            points[3 * i + 2] = 0.3 * r * cos(a) - 2 * r * sin(a);
        }
        check_covers(count, points);
    }
}

TEST(a_hole_joined_by_a_bridge_is_left_free)
{
    /* The bridge is gone twice: four corners stand in two places. */
    static const double xy[][2] = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0},
                                   {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}};
    double points[3 * 10], sum[3] = {0, 0, 0};
    int triangles[3 * 8];
    bool is_odd = true;
    for (int i = 0; i < 10; i++) {
        points[3 * i] = xy[i][0], points[3 * i + 1] = xy[i][1], points[3 * i + 2] = 1;
    }
    bat_polygon_triangles(10, points, triangles, &is_odd);
    CHECK(!is_odd);
    for (int i = 0; i < 8; i++) {
        const int *t = triangles + 3 * i;
        double one[3] = {0, 0, 0};
        area_of(points + 3 * t[0], points + 3 * t[1], points + 3 * t[2], one);
        CHECK(one[2] >= 0);
        sum[2] += one[2];
    }
    CHECK_NEAR(sum[2], 2 * (36 - 4), 1e-12);
}

TEST(a_polygon_that_crosses_itself_is_odd)
{
    static const double bow[] = {0, 0, 0, 2, 2, 0, 2, 0, 0, 0, 1, 0};
    int triangles[6];
    bool is_odd = false;
    bat_polygon_triangles(4, bow, triangles, &is_odd);
    CHECK(is_odd);
    for (int i = 0; i < 6; i++)
        CHECK(triangles[i] >= 0 && triangles[i] < 4);
}

TEST(a_triangle_is_itself)
{
    int triangles[3] = {9, 9, 9};
    bool is_odd = true;
    bat_polygon_triangles(3, (const double[9]){0}, triangles, &is_odd);
    CHECK(!is_odd);
    for (int k = 0; k < 3; k++)
        CHECK_INT(triangles[k], k);
}

/* A circle with one corner pushed in: a bay. */
static void bay(int count, double *points)
{
    for (int i = 0; i < count; i++) {
        const double r = i == count / 2 ? 0.5 : 1, a = 6.283185307179586 * i / count;
        points[3 * i] = r * cos(a), points[3 * i + 1] = r * sin(a), points[3 * i + 2] = 0;
    }
    points[3] *= 0.1, points[4] *= 0.1; /* the fan from corner 0 does not cover it */
}

TEST(a_bay_is_cut_well_up_to_the_limit_of_corners_and_odd_above)
{
    double points[3 * MOST];
    int triangles[3 * MOST];
    bool is_odd = true;
    bay(BAT_POLYGON_MOST, points);
    check_covers(BAT_POLYGON_MOST, points);
    bay(BAT_POLYGON_MOST + 1, points);
    bat_polygon_triangles(BAT_POLYGON_MOST + 1, points, triangles, &is_odd);
    CHECK(is_odd);
    for (int i = 0; i < BAT_POLYGON_MOST - 1; i++) { /* a fan */
        CHECK_INT(triangles[3 * i], 0);
        CHECK_INT(triangles[3 * i + 1], i + 1);
        CHECK_INT(triangles[3 * i + 2], i + 2);
    }
}

TEST(polygons_of_huge_coordinates_are_covered_without_overflow)
{
    const double m = 1e308;
    const double points[] = {-m, -m, 0, m, 0, 0, -m, m, 0, -m / 2, 0, 0};
    int triangles[6];
    bool is_odd = true, has_tip[2] = {false, false};
    bat_polygon_triangles(4, points, triangles, &is_odd);
    CHECK(!is_odd);
    for (int i = 0; i < 6; i++) /* both have the corner of the bay */
        has_tip[i / 3] = has_tip[i / 3] || triangles[i] == 3;
    CHECK(has_tip[0] && has_tip[1]);
}

/* ---- corners ---- */

TEST(without_normals_corners_are_numbered_as_their_vertices_come_up)
{
    static const int corners[] = {5, 2, 3, 3, 2, 0}, due[] = {0, 1, 2, 2, 1, 3};
    static const int sources[] = {0, 1, 2, 5};
    const batten_mesh_parts parts = {
        .vertex_count = 6, .triangle_count = 2, .corners = corners};
    bat_corners numbers;
    CHECK_OK(bat_number_corners(&parts, &numbers));
    CHECK_INT(numbers.count, 4);
    for (int i = 0; i < 6; i++)
        CHECK_INT(numbers.index[i], due[i]);
    for (int i = 0; i < 4; i++)
        CHECK_INT(numbers.source[i], sources[i]);
    bat_corners_end(&numbers);
}

TEST(corners_at_one_vertex_are_one_while_their_normals_agree)
{
    static const int corners[] = {0, 1, 2, 0, 2, 3, 0, 3, 1};
    double normals[27];
    const batten_mesh_parts parts = {
        .vertex_count = 4, .triangle_count = 3, .corners = corners, .normals = normals};
    for (int i = 0; i < 9; i++) { /* the last triangle is turned, and in its z alone */
        normals[3 * i] = 0, normals[3 * i + 1] = 0;
        normals[3 * i + 2] = i < 6 ? 1 : -1;
    }
    bat_corners numbers;
    CHECK_OK(bat_number_corners(&parts, &numbers));
    static const int due[] = {0, 1, 2, 0, 2, 3, 4, 5, 6};
    CHECK_INT(numbers.count, 7);
    for (int i = 0; i < 9; i++) {
        CHECK_INT(numbers.index[i], due[i]);
        CHECK_INT(corners[numbers.source[numbers.index[i]]], corners[i]);
    }
    bat_corners_end(&numbers);
}

/* ---- names and remarks ---- */

TEST(a_name_loses_what_is_blank_around_it)
{
    static const struct {
        const char *name, *core;
    } cases[] = {{"keel", "keel"},
                 {" \t\nkeel \x01", "keel"},
                 {"a b", "a b"},
                 {"", "mesh"},
                 {" \x1f\r", "mesh"},
                 {"!", "!"},
                 {" \xc3\xbc ", "\xc3\xbc"}};
    for (int i = 0; i < COUNT(cases); i++) {
        const bat_span core = bat_name_core(cases[i].name, "mesh");
        CHECK_INT((long long)core.length, (long long)strlen(cases[i].core));
        CHECK(memcmp(core.bytes, cases[i].core, core.length) == 0);
    }
}

TEST(triangles_without_area_are_counted_and_remarked)
{
    static const double points[] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0};
    static const int corners[] = {0, 1, 2, 0, 1, 3, 0, 0, 3};
    batten_mesh *mesh = NULL;
    batten_notes *notes = NULL;
    for (int count = 2; count <= 3; count++) {
        CHECK_OK(batten_notes_create(9, &notes));
        CHECK_OK(batten_mesh_create(&(batten_mesh_parts){.vertex_count = 4,
                                                         .points = points,
                                                         .triangle_count = count,
                                                         .corners = corners},
                                    &mesh));
        CHECK_INT(bat_count_flat(mesh), count - 1);
        bat_remark_flat(mesh, "a.off", "hull", notes);
        if (!batten_notes_dropped(notes)) {
            CHECK_INT(batten_notes_count(notes), 1);
            const batten_note *note = batten_notes_at(notes, 0);
            CHECK_TEXT(note->text, count == 2 ? "1 of 2 triangles have no area; kept"
                                              : "2 of 3 triangles have no area; kept");
            CHECK_TEXT(note->file, "a.off");
            CHECK_TEXT(note->entity, "hull");
            CHECK(note->is_remark && note->line == 0);
        }
        batten_mesh_unref(mesh);
        batten_notes_free(notes);
        mesh = NULL, notes = NULL;
    }
}

TEST(a_mesh_of_areas_and_a_model_without_unit_are_not_remarked)
{
    const batten_mesh_parts parts = tetrahedron();
    batten_mesh *mesh = NULL;
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(9, &notes));
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(batten_model_create(0, &model));
    bat_remark_flat(mesh, "", "", notes);
    bat_remark_unit(model, "OFF", notes);
    CHECK_INT(batten_notes_count(notes), 0);
    batten_model_unref(model);
    model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    bat_remark_unit(model, "OFF", notes);
    if (!batten_notes_dropped(notes)) {
        CHECK_INT(batten_notes_count(notes), 1);
        CHECK_TEXT(batten_notes_at(notes, 0)->text,
                   "OFF files name no unit; the numbers are in units of 0.001 m");
        CHECK_INT(batten_notes_at(notes, 0)->line, 0);
    }
    batten_model_unref(model);
    batten_mesh_unref(mesh);
    batten_notes_free(notes);
}
