/* What 32 bits for a coordinate do to a mesh. */
#include "exchange/meshes/facets.h"
#include "exchange/meshes/meshes.h"

/* A closed box 1000 away from the origin of which the sides are cut into strips as narrow as a
 * part of what 32 bits tell apart there. */
static batten_mesh *striped_box(int strips, double width)
{
    const int around = 2 * strips + 2;
    double *points = test_array((size_t)(2 * around), 3 * sizeof *points);
    int *corners = test_array((size_t)(4 * around), 3 * sizeof *corners), count = 0;
    batten_mesh *mesh = NULL;
    for (int i = 0; i < around; i++)
        for (int k = 0; k < 2; k++) { /* out along y = 0, back along y = 1 */
            double *at = points + 3 * (2 * i + k);
            at[0] = 1000 + width * (i <= strips ? i : 2 * strips + 1 - i);
            at[1] = i <= strips ? 0 : 1;
            at[2] = k;
        }
    for (int i = 0; i < around; i++) {
        const int a = 2 * i, b = 2 * ((i + 1) % around);
        const int made[6] = {a, b, b + 1, a, b + 1, a + 1};
        memcpy(corners + 3 * count, made, sizeof made);
        count += 2;
    }
    for (int i = 0; i < strips; i++) { /* below and above */
        const int a = 2 * i, b = a + 2, d = 2 * (2 * strips + 1 - i), c = d - 2;
        const int made[12] = {a, c, b, a, d, c, a + 1, b + 1, c + 1, a + 1, c + 1, d + 1};
        memcpy(corners + 3 * count, made, sizeof made);
        count += 4;
    }
    const batten_mesh_parts parts = {.vertex_count = 2 * around,
                                     .points = points,
                                     .triangle_count = count,
                                     .corners = corners};
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    return mesh;
}

static void check_rounded(const batten_mesh_parts *parts, int left, const char *words)
{
    static const batten_format formats[] = {BATTEN_FORMAT_STL, BATTEN_FORMAT_GLTF};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(model, "m", parts);
    for (int i = 0; i < 2; i++) {
        batten_notes *notes = NULL;
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(write_form(model, formats[i], false, notes, &data, &size));
        if (i == 0)
            CHECK_INT((long long)size, 84 + 50 * (long long)left);
        if (batten_notes_dropped(notes) == 0)
            CHECK(has_note(notes, words));
        batten_release(data);
        batten_notes_free(notes);
    }
    batten_model_unref(model);
}

TEST(triangles_whose_corners_round_to_one_place_are_not_written_and_a_closed_mesh_stays_closed)
{
    batten_mesh *box = striped_box(20, 1e-5);
    batten_model *model = NULL, *back = NULL;
    batten_mesh_facts facts;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_mesh_check(box, &facts));
    CHECK(facts.is_watertight);
    CHECK_INT(facts.flat_triangles, 0);
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(model, "box", batten_mesh_view(box));
    CHECK_OK(write_form(model, BATTEN_FORMAT_STL, false, NULL, &data, &size));
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_STL, NULL, &back));
    CHECK_OK(batten_mesh_check(batten_model_object(back, 0)->mesh, &facts));
    CHECK(facts.is_watertight);
    CHECK_INT(facts.flat_triangles + facts.crowded_edges, 0);
    const int left = mesh_at(back, 0)->triangle_count;
    CHECK(left >= 28 && left < batten_mesh_view(box)->triangle_count);
    check_rounded(batten_mesh_view(box), left,
                  "are not written: rounded to 32 bits, two of their corners are one");
    batten_release(data);
    batten_model_unref(back);
    batten_model_unref(model);
    batten_mesh_unref(box);
}

TEST(what_rounding_makes_worse_is_counted)
{
    /* Two tetrahedra whose edges along z are nearer than 32 bits tell. */
    double points[8][3];
    int corners[8][3];
    for (int i = 0; i < 8; i++) {
        const double side = i < 4 ? 1 : -1;
        points[i][0] = 1000 + side * ((i % 4 < 2 ? 1e-6 : 1));
        points[i][1] = i % 4 == 2 ? -1 : i % 4 == 3 ? 1 : 0;
        points[i][2] = i % 4 == 1;
    }
    for (int i = 0; i < 8; i++)
        for (int k = 0; k < 3; k++) {
            const int from = i < 4 ? k : 2 - k;
            corners[i][k] = tetrahedron_corners[3 * (i % 4) + from] + (i < 4 ? 0 : 4);
        }
    const batten_mesh_parts parts = {
        .vertex_count = 8, .points = points[0], .triangle_count = 8, .corners = corners[0]};
    check_rounded(
        &parts, 8,
        "triangles without area, 0 more, and edges of more than two triangles, 1 more");
}

TEST(triangles_without_area_before_rounding_stay)
{
    static const double points[] = {0, 0, 0, 0.5, 0, 0, 0.1, 0.7, 0};
    static const int corners[] = {0, 1, 2, 0, 1, 1};
    const batten_mesh_parts parts = {
        .vertex_count = 3, .points = points, .triangle_count = 2, .corners = corners};
    check_rounded(&parts, 2, "coordinates are rounded to 32 bits");
}

/* A square around 1000 of two triangles, and between them two that are too narrow for 32 bits. */
static const double narrow_points[] = {1000, 0, 0, 1001,       0, 0, 1001, 1,          0,
                                       1000, 1, 0, 1000.00001, 0, 0, 1000, 1.00000001, 0};
static const int narrow_corners[] = {0, 1, 2, 0, 4, 1, 3, 2, 5, 0, 2, 3};
static const int narrow_faces[] = {7, 8, 9, 10};

/* Numbers that say to which triangle they belong: 9 of normals, 3 of a colour. */
static batten_mesh *narrow_mesh(bool is_bare)
{
    double normals[36], colours[12];
    batten_mesh *mesh = NULL;
    for (int i = 0; i < 36; i++)
        normals[i] = i % 3 == i / 9 % 3 ? 1 : 0;
    for (int i = 0; i < 12; i++)
        colours[i] = (i / 3 + 0.1 * (i % 3)) / 4;
    const batten_mesh_parts parts = {.vertex_count = 6,
                                     .points = narrow_points,
                                     .triangle_count = 4,
                                     .corners = narrow_corners,
                                     .faces = is_bare ? NULL : narrow_faces,
                                     .normals = is_bare ? NULL : normals,
                                     .triangle_colours = is_bare ? NULL : colours};
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    return mesh;
}

TEST(triangles_that_stay_keep_their_corners_faces_normals_and_colours)
{
    for (int is_bare = 0; is_bare < 2; is_bare++) {
        batten_mesh *mesh = narrow_mesh(is_bare), *left = NULL;
        const batten_object object = {.name = "m", .kind = BATTEN_OBJECT_MESH, .mesh = mesh};
        CHECK_OK(bat_rounded_mesh(&object, 1, NULL, &left));
        const batten_mesh_parts *p = batten_mesh_view(mesh), *q = batten_mesh_view(left);
        CHECK_INT(q->triangle_count, 2);
        CHECK_INT(q->vertex_count, 6);
        CHECK((q->faces == NULL) == is_bare && (q->normals == NULL) == is_bare &&
              (q->triangle_colours == NULL) == is_bare);
        for (int t = 0; t < 2; t++) {
            const int from = 3 * t; /* the first and the last */
            CHECK(memcmp(q->corners + 3 * t, p->corners + 3 * from, 3 * sizeof(int)) == 0);
            if (is_bare)
                continue;
            CHECK_INT(q->faces[t], p->faces[from]);
            CHECK(memcmp(q->normals + 9 * t, p->normals + 9 * from, 9 * sizeof(double)) == 0);
            CHECK(memcmp(q->triangle_colours + 3 * t, p->triangle_colours + 3 * from,
                         3 * sizeof(double)) == 0);
        }
        batten_mesh_unref(left);
        batten_mesh_unref(mesh);
    }
}

TEST(a_mesh_that_32_bits_hold_is_the_same_mesh)
{
    static const double points[] = {0, 0, 0, 0.5, 0, 0, 0, 0.25, 0};
    static const int corners[] = {0, 1, 2};
    const batten_mesh_parts parts = {
        .vertex_count = 3, .points = points, .triangle_count = 1, .corners = corners};
    batten_mesh *mesh = NULL, *left = NULL;
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    const batten_object object = {.name = "m", .kind = BATTEN_OBJECT_MESH, .mesh = mesh};
    CHECK_OK(bat_rounded_mesh(&object, 1, NULL, &left));
    CHECK(left == mesh);
    batten_mesh_unref(left);
    batten_mesh_unref(mesh);
}

/* 32 bits tell 2^24 and 2^24 + 1 not apart, but three times as much. */
TEST(coordinates_are_rounded_in_the_scale_of_the_file)
{
    static const double points[] = {16777216, 0, 0, 16777217, 0, 0, 16777216, 9, 0};
    static const int corners[] = {0, 1, 2}, gone[] = {1, 0};
    static const double scales[] = {1, 3};
    batten_mesh *mesh = NULL;
    const batten_mesh_parts parts = {
        .vertex_count = 3, .points = points, .triangle_count = 1, .corners = corners};
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    for (int i = 0; i < COUNT(scales); i++) {
        const batten_object object = {.name = "m", .kind = BATTEN_OBJECT_MESH, .mesh = mesh};
        batten_mesh *left = NULL;
        CHECK_OK(bat_rounded_mesh(&object, scales[i], NULL, &left));
        CHECK_INT(batten_mesh_view(left)->triangle_count, 1 - gone[i]);
        batten_mesh_unref(left);
    }
    batten_mesh_unref(mesh);
}

/* All notes, with their counts. */
TEST(what_is_said_of_rounding_is_said_with_its_numbers)
{
    batten_mesh *mesh = narrow_mesh(true), *left = NULL;
    batten_notes *notes = NULL;
    const batten_object object = {.name = "m", .kind = BATTEN_OBJECT_MESH, .mesh = mesh};
    CHECK_OK(batten_notes_create(9, &notes));
    CHECK_OK(bat_rounded_mesh(&object, 1, notes, &left));
    if (test_cases(1000) >= 1000) {
        CHECK_INT(batten_notes_count(notes), 1);
        CHECK(batten_notes_at(notes, 0)->is_remark);
        CHECK_TEXT(batten_notes_at(notes, 0)->text,
                   "2 of 4 triangles are not written: rounded to 32 bits, two of their corners "
                   "are one");
    }
    batten_notes_free(notes);
    batten_mesh_unref(left);
    batten_mesh_unref(mesh);
}
