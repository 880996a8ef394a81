/* What a reader of glTF sees of a model: triangle by triangle, from the JSON and the bytes. */
#include "exchange/meshes/meshes.h"
#include "exchange/reading/bytes.h"
#include "support/json.h"

typedef struct {
    const char *json, *bytes;
    char *data;
    batten_notes *notes;
} glb;

static glb written_glb(const batten_model *model)
{
    glb g = {.data = NULL};
    size_t size = 0;
    CHECK_OK(batten_notes_create(20, &g.notes));
    CHECK_OK(write_form(model, BATTEN_FORMAT_GLTF, false, g.notes, &g.data, &size));
    const size_t length = bat_bytes_u32(g.data + 12);
    char *json = test_array(length + 1, 1);
    memcpy(json, g.data + 20, length);
    g.json = json;
    g.bytes = g.data + 28 + length;
    return g;
}

static void end_glb(glb *g)
{
    batten_release(g->data);
    batten_notes_free(g->notes);
}

/* The value of a key, or `otherwise` when the object has none. */
static int whole_of(const char *object, const char *key, int otherwise)
{
    const char *at = json_try(object, key);
    return at ? (int)json_number(at) : otherwise;
}

/* Where item `index` of an accessor stands, items of `size` bytes; the bounds are checked. */
static const char *item_of(const glb *g, int accessor, int index, int size)
{
    const char *a = json_item(json_key(g->json, "accessors"), accessor);
    const char *view =
        json_item(json_key(g->json, "bufferViews"), whole_of(a, "bufferView", -1));
    const int count = whole_of(a, "count", -1), length = whole_of(view, "byteLength", -1);
    CHECK(index >= 0 && index < count);
    CHECK_INT(length, count * size);
    CHECK_INT(whole_of(a, "componentType", 0), size == 4 ? 5125 : 5126);
    CHECK_INT(whole_of(view, "target", 0), size == 4 ? 34963 : 34962);
    const int offset = whole_of(view, "byteOffset", -1);
    const char *buffer = json_item(json_key(g->json, "buffers"), 0);
    CHECK(offset + length <= whole_of(buffer, "byteLength", 0) && offset % 4 == 0);
    return g->bytes + offset + index * size;
}

static void vector_of(const glb *g, int accessor, int index, double out[3])
{
    const char *at = item_of(g, accessor, index, 12);
    for (int k = 0; k < 3; k++)
        out[k] = bat_bytes_float(at + 4 * k, false);
}

/* From y up to z up. */
static void set_upright(const double in[3], double out[3])
{
    const double turned[3] = {in[0], -in[2], in[1]};
    memcpy(out, turned, sizeof turned);
}

/* The light of glTF as sRGB. */
static double shown(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055;
}

typedef struct {
    double at[3][3], normal[3][3], colour[3][3];
    bool has_normal, has_colour;
} facet;

enum { MOST = 100 };
typedef struct {
    facet facets[MOST];
    int count;
} scene;

static void see_primitive(const glb *g, const char *primitive, const double matrix[16],
                          scene *s)
{
    const char *attributes = json_key(primitive, "attributes");
    const int indices = whole_of(primitive, "indices", -1);
    const int normals = whole_of(attributes, "NORMAL", -1);
    const int colours = whole_of(attributes, "COLOR_0", -1);
    const int material = whole_of(primitive, "material", -1);
    const int count = whole_of(json_item(json_key(g->json, "accessors"), indices), "count", 0);
    CHECK_INT(count % 3, 0);
    for (int i = 0; i < count; i++) {
        CHECK(s->count < MOST);
        facet *f = &s->facets[s->count];
        const int vertex = (int)bat_bytes_u32(item_of(g, indices, i, 4)), k = i % 3;
        double p[3], moved[3];
        vector_of(g, whole_of(attributes, "POSITION", -1), vertex, p);
        for (int row = 0; row < 3; row++)
            moved[row] = matrix[row] * p[0] + matrix[4 + row] * p[1] + matrix[8 + row] * p[2] +
                         matrix[12 + row];
        set_upright(moved, f->at[k]);
        f->has_normal = normals >= 0;
        f->has_colour = colours >= 0 || material >= 0;
        if (normals >= 0) {
            vector_of(g, normals, vertex, p);
            set_upright(p, f->normal[k]);
        }
        double light[4] = {0};
        if (material >= 0)
            json_numbers(json_key(json_key(json_item(json_key(g->json, "materials"), material),
                                           "pbrMetallicRoughness"),
                                  "baseColorFactor"),
                         4, light);
        if (colours >= 0)
            vector_of(g, colours, vertex, light);
        CHECK(colours < 0 || material < 0); /* they would be multiplied */
        for (int c = 0; c < 3; c++)
            f->colour[k][c] = shown(light[c]);
        s->count += k == 2;
    }
}

static void see_node(const glb *g, int index, const double above[16], scene *s)
{
    const char *node = json_item(json_key(g->json, "nodes"), index);
    double own[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, matrix[16];
    if (json_try(node, "matrix"))
        CHECK_INT(json_numbers(json_try(node, "matrix"), 16, own), 16);
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++) {
            matrix[4 * column + row] = 0;
            for (int k = 0; k < 4; k++)
                matrix[4 * column + row] += above[4 * k + row] * own[4 * column + k];
        }
    const int mesh = whole_of(node, "mesh", -1);
    const char *primitives =
        mesh < 0 ? NULL : json_key(json_item(json_key(g->json, "meshes"), mesh), "primitives");
    for (int k = 0; primitives && json_item(primitives, k); k++)
        see_primitive(g, json_item(primitives, k), matrix, s);
    const char *children = json_try(node, "children");
    for (int k = 0; children && json_item(children, k); k++)
        see_node(g, (int)json_number(json_item(children, k)), matrix, s);
}

static scene *see(const glb *g)
{
    static const double still[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    scene *s = test_array(1, sizeof *s);
    const char *roots = json_try(json_item(json_key(g->json, "scenes"), 0), "nodes");
    for (int k = 0; roots && json_item(roots, k); k++)
        see_node(g, (int)json_number(json_item(roots, k)), still, s);
    return s;
}

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
    glb g = written_glb(model);
    CHECK(has_note(g.notes, "the model has no unit; its numbers are taken as metres"));
    CHECK(has_note(g.notes, "the normals are left out: ("));
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
