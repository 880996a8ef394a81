/* Meshes of glTF as a reader sees them: corners, normals, colours, bounds, and where instances put them. */
#include "exchange/gltf/seen.h"

static void only_once(void)
{
    if (test_cases(1000) < 1000)
        SKIP("what missing memory does is a test of the corpora");
}

/* A tetrahedron of which every corner has its own normal and every vertex its own colour. */
static const double vertex_colours[12] = {0,   0.02, 1,   0.5, 0.25, 0.75,
                                          0.1, 0.9,  0.3, 1,   1,    0.04};
static const double face_colours[12] = {1, 0, 0, 0, 1, 0, 1, 0, 0, 0.2, 0.4, 0.6};

static void corner_normals(double normals[36])
{
    for (int i = 0; i < 12; i++) {
        const double a = i + 1, b = 0.3 * i;
        normals[3 * i] = cos(a) * cos(b);
        normals[3 * i + 1] = sin(a) * cos(b);
        normals[3 * i + 2] = sin(b);
    }
}

/* The facets from `first` on are those of the mesh, in this order of triangles, so placed. */
static void check_facets(const scene *s, int first, const batten_mesh_parts *p,
                         const batten_affine *place, double unit, const int order[4])
{
    CHECK(s->count >= first + p->triangle_count);
    for (int t = 0; t < p->triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            const facet *f = &s->facets[first + t];
            const int corner = 3 * order[t] + k, vertex = p->corners[corner];
            for (int row = 0; row < 3; row++) {
                double due = place->t[row];
                for (int c = 0; c < 3; c++)
                    due += place->m[row][c] * p->points[3 * vertex + c];
                CHECK_NEAR(f->at[k][row], unit * due, 1e-6 * unit);
                if (p->normals)
                    CHECK_NEAR(f->normal[k][row], p->normals[3 * corner + row], 1e-6);
                if (p->colours)
                    CHECK_NEAR(f->colour[k][row], p->colours[3 * vertex + row], 1e-5);
                else if (p->triangle_colours)
                    CHECK_NEAR(f->colour[k][row], p->triangle_colours[3 * order[t] + row],
                               1e-5);
            }
            CHECK_INT(f->has_normal, p->normals != NULL);
            CHECK_INT(f->has_colour, p->colours || p->triangle_colours);
        }
}

static const int in_order[4] = {0, 1, 2, 3};

TEST(a_reader_sees_corners_normals_and_colours_where_they_are)
{
    double normals[36];
    only_once();
    corner_normals(normals);
    for (int bits = 0; bits < 4; bits++) {
        batten_model *model = NULL;
        batten_mesh_parts parts = tetrahedron();
        const batten_affine still = batten_affine_identity();
        parts.normals = bits & 1 ? normals : NULL;
        parts.colours = bits & 2 ? vertex_colours : NULL;
        CHECK_OK(batten_model_create(0.5, &model));
        add_mesh(model, "first", &parts);
        add_mesh(model, "second", &parts);
        glb g = written_glb(model);
        const scene *s = see(&g);
        CHECK_INT(s->count, 8);
        check_facets(s, 0, &parts, &still, 0.5, in_order);
        check_facets(s, 4, &parts, &still, 0.5, in_order);
        CHECK_INT(count_warnings(g.notes), 0);
        end_glb(&g);
        batten_model_unref(model);
    }
}

TEST(a_reader_sees_triangles_in_their_colours_grouped_by_them)
{
    only_once();
    batten_model *model = NULL;
    batten_mesh_parts parts = tetrahedron();
    parts.triangle_colours = face_colours;
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(model, "tip", &parts);
    glb g = written_glb(model);
    scene *s = see(&g);
    CHECK_INT(s->count, 4);
    /* In which order colours come is free: each triangle must be there in its own. */
    for (int t = 0; t < 4; t++) {
        int found = 0;
        for (int k = 0; k < 4; k++) {
            bool same = true;
            for (int c = 0; c < 9; c++)
                same =
                    same && fabs(s->facets[k].at[c / 3][c % 3] -
                                 parts.points[3 * parts.corners[3 * t + c / 3] + c % 3]) < 1e-6;
            if (!same)
                continue;
            found++;
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(s->facets[k].colour[0][c], face_colours[3 * t + c], 1e-5);
        }
        CHECK_INT(found, 1);
    }
    end_glb(&g);
    batten_model_unref(model);
}

TEST(a_reader_sees_instances_within_instances_where_their_places_put_them)
{
    only_once();
    const batten_mesh_parts parts = tetrahedron();
    batten_model *bolt = NULL, *plate = NULL, *model = NULL;
    /* A quarter turn about z with a shift, and one about x scaled by 2. */
    const batten_affine outer = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, {1, 2, 3}};
    const batten_affine inner = {{{2, 0, 0}, {0, 0, -2}, {0, 2, 0}}, {-4, 5, 6}};
    /* outer after inner */
    const batten_affine both = {{{0, 0, 2}, {2, 0, 0}, {0, 2, 0}}, {1 - 5, 2 - 4, 3 + 6}};
    CHECK_OK(batten_model_create(0.001, &bolt));
    CHECK_OK(batten_model_create(0.001, &plate));
    CHECK_OK(batten_model_create(0.001, &model));
    add_mesh(bolt, "bolt", &parts);
    CHECK_OK(batten_model_add(plate, &(batten_object){.name = "bolt",
                                                      .kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = bolt,
                                                      .place = inner}));
    add_mesh(plate, "plate", &parts);
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(
            model, &(batten_object){.name = i ? "there" : "here",
                                    .kind = BATTEN_OBJECT_INSTANCE,
                                    .definition = plate,
                                    .place = i ? outer : batten_affine_identity()}));
    batten_model_unref(bolt);
    batten_model_unref(plate);
    glb g = written_glb(model);
    const scene *s = see(&g);
    const batten_affine still = batten_affine_identity();
    CHECK_INT(s->count, 16);
    check_facets(s, 0, &parts, &inner, 0.001, in_order);
    check_facets(s, 4, &parts, &still, 0.001, in_order);
    check_facets(s, 8, &parts, &both, 0.001, in_order);
    check_facets(s, 12, &parts, &outer, 0.001, in_order);
    CHECK_INT(count_warnings(g.notes), 0);
    end_glb(&g);
    batten_model_unref(model);
}

TEST(a_sheared_place_is_noted_whichever_axes_lean)
{
    only_once();
    const batten_mesh_parts parts = tetrahedron();
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            for (int small = 0; small < 2; small++) {
                batten_model *inner = NULL, *model = NULL;
                batten_affine place = batten_affine_identity();
                place.m[row][column] += small ? 1e-12 : 0.5;
                CHECK_OK(batten_model_create(1, &inner));
                CHECK_OK(batten_model_create(1, &model));
                add_mesh(inner, "m", &parts);
                CHECK_OK(
                    batten_model_add(model, &(batten_object){.name = "i",
                                                             .kind = BATTEN_OBJECT_INSTANCE,
                                                             .definition = inner,
                                                             .place = place}));
                glb g = written_glb(model);
                CHECK_INT(has_note(g.notes, "its place is sheared, which glTF does not allow"),
                          row != column && !small);
                end_glb(&g);
                batten_model_unref(inner);
                batten_model_unref(model);
            }
}

TEST(what_is_left_out_or_taken_for_granted_is_noted_with_its_object)
{
    only_once();
    static const double points[] = {0, 0, 0, 1, 0, 0};
    double normals[36];
    batten_model *model = NULL;
    batten_mesh_parts parts = tetrahedron();
    corner_normals(normals);
    CHECK_OK(batten_model_create(0, &model));
    normals[31] *= 3;
    parts.normals = normals;
    parts.colours = vertex_colours;
    parts.triangle_colours = face_colours;
    add_mesh(model, "hull", &parts);
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "marks",
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 2,
                                                      .points = points}));
    char said[200];
    snprintf(said, sizeof said, "the normals are left out: (%g, %g, %g) has not the length 1",
             normals[30], normals[31], normals[32]);
    glb g = written_glb(model);
    CHECK(has_note(g.notes, "the model has no unit; its numbers are taken as metres"));
    CHECK(has_note(g.notes, said));
    CHECK(has_note(g.notes,
                   "the colours of its faces are left out: its vertices have colours too"));
    for (int i = 0; i < batten_notes_count(g.notes); i++)
        CHECK_INT(batten_notes_at(g.notes, i)->line, 0);
    const scene *s = see(&g);
    const batten_affine still = batten_affine_identity();
    CHECK_INT(s->count, 4);
    parts.normals = NULL;
    check_facets(s, 0, &parts, &still, 1, in_order);
    end_glb(&g);
    batten_model_unref(model);
}

TEST(normals_of_nearly_the_length_1_are_written_with_it)
{
    only_once();
    double normals[36];
    batten_model *model = NULL;
    batten_mesh_parts parts = tetrahedron();
    corner_normals(normals);
    for (int i = 0; i < 36; i++)
        normals[i] *= 1.0009;
    parts.normals = normals;
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(model, "m", &parts);
    glb g = written_glb(model);
    const scene *s = see(&g);
    for (int i = 0; i < 12; i++) {
        const double *n = s->facets[i / 3].normal[i % 3];
        CHECK_NEAR(hypot(hypot(n[0], n[1]), n[2]), 1, 2e-7);
    }
    end_glb(&g);
    batten_model_unref(model);
}

TEST(bounds_are_those_of_the_positions)
{
    only_once();
    static const double points[] = {-3, 5, 7, -1, -2, 4, -6, 8, 9};
    const batten_mesh_parts parts = {.vertex_count = 3,
                                     .points = points,
                                     .triangle_count = 1,
                                     .corners = (const int[]){0, 1, 2}};
    batten_model *model = NULL;
    double low[3], high[3];
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(model, "m", &parts);
    glb g = written_glb(model);
    const char *accessor = json_item(json_key(g.json, "accessors"), 0);
    json_numbers(json_key(accessor, "min"), 3, low);
    json_numbers(json_key(accessor, "max"), 3, high);
    static const double least[] = {-6, 4, -8}, most[] = {-1, 9, 2};
    for (int k = 0; k < 3; k++) {
        CHECK_BITS(low[k], least[k]);
        CHECK_BITS(high[k], most[k]);
    }
    end_glb(&g);
    batten_model_unref(model);
}
