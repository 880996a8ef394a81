/* Which edges of a mesh are drawn. */
#include "picture/lines/stroke.h"

#include "picture/scenes.h"

#include <batten/mesh.h>

static const double RADIAN = 0.017453292519943295;

/* Two triangles over [-1, 1] x [0, 2] that meet in the edge x = 0, each of which falls by `angle` degrees. */
static batten_mesh *roof(double angle, const int *faces)
{
    const double c = cos(angle * RADIAN), s = sin(angle * RADIAN);
    const double points[] = {0, 0, 0, 0, 2, 0, -c, 0, -s, c, 0, -s};
    static const int corners[] = {0, 1, 2, 0, 3, 1};
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_mesh_create(&(batten_mesh_parts){.vertex_count = 4,
                                                     .points = points,
                                                     .triangle_count = 2,
                                                     .corners = corners,
                                                     .faces = faces},
                                &mesh));
    return mesh;
}

/* The lines, and how long they are in all. */
static bat_strokes lines_of(const batten_mesh *mesh, bat_mesh_lines which,
                            const bat_mesh_eye *eye, double *length)
{
    bat_strokes lines = {0};
    batten_status status;
    do { /* with a failing allocation once more, from the start */
        bat_strokes_free(&lines);
        status = bat_stroke_mesh(mesh, which, eye, &lines);
    } while (test_memory_failed(status, BATTEN_OK));
    CHECK(status == BATTEN_OK);
    *length = 0;
    for (size_t i = 0; i < lines.count; i++)
        for (size_t k = 1; k < lines.strokes[i].count; k++) {
            const double *p = lines.strokes[i].points + 3 * k;
            *length += hypot(hypot(p[0] - p[-3], p[1] - p[-2]), p[2] - p[-1]);
        }
    return lines;
}

/* A ridge between slopes of `angle` turns the normal by twice as much. */
static const struct {
    double angle;
    bat_mesh_lines which;
    bool ridge; /* is drawn */
} drawn[] = {
    {14.9, BAT_MESH_EDGES, false},        {15.1, BAT_MESH_EDGES, true},
    {-14.9, BAT_MESH_EDGES, false},       {-15.1, BAT_MESH_EDGES, true},
    {14.9, BAT_MESH_EDGES_OR_ALL, false}, {15.1, BAT_MESH_EDGES_OR_ALL, true},
    {14.9, BAT_MESH_ALL, true},           {0, BAT_MESH_ALL, true},
};

/* Two edges of length 1 and sqrt 5 at each side, and the ridge of length 2. */
TEST(an_edge_where_a_mesh_turns_by_more_than_30_degrees_is_drawn)
{
    for (int i = 0; i < COUNT(drawn); i++) {
        batten_mesh *mesh = roof(drawn[i].angle, NULL);
        double length;
        bat_strokes lines = lines_of(mesh, drawn[i].which, NULL, &length);
        CHECK_NEAR(length, 2 + 2 * sqrt(5) + 2 * drawn[i].ridge, 1e-12);
        /* Where three edges meet lines end. */
        CHECK_INT(lines.count, drawn[i].ridge ? 3 : 1);
        bat_strokes_free(&lines);
        batten_mesh_unref(mesh);
    }
}

TEST(of_a_body_the_edges_between_its_faces_are_drawn)
{
    for (int other = 0; other < 2; other++) {
        const int faces[] = {4, 4 + other};
        batten_mesh *mesh = roof(other ? 0 : 40, faces);
        double length;
        bat_strokes lines = lines_of(mesh, BAT_MESH_EDGES, NULL, &length);
        CHECK_NEAR(length, 2 + 2 * sqrt(5) + 2 * other, 1e-12);
        bat_strokes_free(&lines);
        batten_mesh_unref(mesh);
    }
}

/* Slopes of 10 degrees: the ridge is an outline for an eye that sees just one of them. */
static const struct {
    double at[3];
    bool is_far, outline;
} eyes[] = {
    {{1, 0, 0.1}, true, true},    {{-1, 0, 0.1}, true, true},    {{1, 0, 0.2}, true, false},
    {{1, 0, -0.1}, true, true},   {{1, 0, -0.2}, true, false},   {{0, 0, 1}, true, false},
    {{0, 1, 0}, true, false},     {{10, 0, 1}, false, true},     {{10, 0, 2}, false, false},
    {{-10, 0, 1.7}, false, true}, {{-10, 5, 1.8}, false, false},
};

TEST(an_outline_lies_between_a_triangle_that_faces_the_eye_and_one_that_does_not)
{
    batten_mesh *mesh = roof(10, NULL);
    for (int i = 0; i < COUNT(eyes); i++) {
        const bat_mesh_eye eye = {{eyes[i].at[0], eyes[i].at[1], eyes[i].at[2]},
                                  eyes[i].is_far};
        double length;
        bat_strokes lines = lines_of(mesh, BAT_MESH_OUTLINE, &eye, &length);
        CHECK_INT(lines.count, eyes[i].outline);
        CHECK_NEAR(length, 2 * eyes[i].outline, 1e-12);
        bat_strokes_free(&lines);
    }
    batten_mesh_unref(mesh);
    /* What is drawn anyhow is not drawn again. */
    mesh = roof(20, NULL);
    double length;
    bat_strokes lines =
        lines_of(mesh, BAT_MESH_OUTLINE, &(bat_mesh_eye){{1, 0, 0.1}, true}, &length);
    CHECK_INT(lines.count, 0);
    bat_strokes_free(&lines);
    batten_mesh_unref(mesh);
}

/* A torus of 24 by 24 sides turns by 15 degrees at each of them at most, and ends nowhere. */
TEST(of_a_mesh_without_edges_all_lines_are_drawn_when_asked_for)
{
    enum { AROUND = 24, ACROSS = 24 };
    double points[AROUND * ACROSS][3];
    int corners[2 * AROUND * ACROSS][3];
    for (int i = 0; i < AROUND; i++)
        for (int j = 0; j < ACROSS; j++) {
            const double a = 15 * i * RADIAN, b = 15 * j * RADIAN, r = 3 + cos(b);
            const int next = (i + 1) % AROUND * ACROSS, up = (j + 1) % ACROSS, k = i * ACROSS;
            memcpy(points[k + j], (double[]){r * cos(a), r * sin(a), sin(b)},
                   sizeof points[k + j]);
            memcpy(corners[2 * (k + j)], (int[]){k + j, next + j, next + up},
                   sizeof corners[0]);
            memcpy(corners[2 * (k + j) + 1], (int[]){k + j, next + up, k + up},
                   sizeof corners[0]);
        }
    batten_mesh *torus = NULL;
    CHECK_OK(batten_mesh_create(&(batten_mesh_parts){.vertex_count = AROUND * ACROSS,
                                                     .points = points[0],
                                                     .triangle_count = 2 * AROUND * ACROSS,
                                                     .corners = corners[0]},
                                &torus));
    double none, all, every;
    bat_strokes lines[3] = {lines_of(torus, BAT_MESH_EDGES, NULL, &none),
                            lines_of(torus, BAT_MESH_EDGES_OR_ALL, NULL, &all),
                            lines_of(torus, BAT_MESH_ALL, NULL, &every)};
    CHECK_INT(lines[0].count, 0);
    CHECK(lines[1].count > 0 && all == every);
    CHECK(none == 0);
    for (int i = 0; i < 3; i++)
        bat_strokes_free(&lines[i]);
    batten_mesh_unref(torus);
}
