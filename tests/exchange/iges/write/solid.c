/* Bodies written whole, as solids and shells. */
#include "exchange/shapes.h"

#include "support/bodies.h"
#include "support/drilled_box.h"

#include <batten/standard.h>
#include <stdio.h>

enum { MOST = 200 };

/* Bodies put together as the shells of one. */
typedef struct {
    double vertices[MOST][3];
    batten_body_edge edges[MOST];
    batten_body_use uses[MOST];
    batten_body_loop loops[MOST];
    batten_body_face faces[MOST];
    batten_body_shell shells[4];
    batten_body_parts parts;
} bundle;

/* The uses of a loop, the other way round for a body that is turned inside out. */
static void add_uses(bundle *b, const batten_body_parts *p, const batten_body_loop *loop,
                     bool turned)
{
    for (int i = 0; i < loop->count; i++) {
        batten_body_use use = p->uses[loop->first + (turned ? loop->count - 1 - i : i)];
        use.reversed = use.reversed != turned;
        use.edge += b->parts.edge_count;
        b->uses[b->parts.use_count++] = use;
    }
}

static void add_shell(bundle *b, const batten_body *body, bool turned)
{
    const batten_body_parts *p = batten_body_view(body);
    batten_body_parts *all = &b->parts;
    b->shells[all->shell_count++] = (batten_body_shell){all->face_count, p->face_count, true};
    for (int f = 0; f < p->face_count; f++) {
        batten_body_face face = p->faces[f];
        face.first = all->loop_count;
        face.reversed = face.reversed != turned;
        for (int l = 0; l < face.count; l++) {
            const batten_body_loop *loop = &p->loops[p->faces[f].first + l];
            b->loops[all->loop_count++] = (batten_body_loop){all->use_count, loop->count};
            add_uses(b, p, loop, turned);
        }
        b->faces[all->face_count++] = face;
    }
    for (int e = 0; e < p->edge_count; e++) {
        batten_body_edge edge = p->edges[e];
        edge.vertices[0] += all->vertex_count;
        edge.vertices[1] += all->vertex_count;
        b->edges[all->edge_count++] = edge;
    }
    for (int v = 0; v < 3 * p->vertex_count; v++)
        b->vertices[all->vertex_count + v / 3][v % 3] = p->vertices[v];
    all->vertex_count += p->vertex_count;
}

/* A box of 10^3 with a drilled box in it: a void, or a body of two shells that is no solid. */
static batten_body *two_shells(bool is_solid)
{
    bundle *b = test_array(1, sizeof *b);
    batten_body *outer = test_box((batten_vec3){-2, -2, -2}, (batten_vec3){8, 8, 8});
    batten_body *inner = NULL, *both = NULL;
    CHECK_OK(drilled_box(&inner));
    add_shell(b, outer, false);
    add_shell(b, inner, is_solid);
    b->faces[3].has_colour = true;
    b->faces[3].colour[0] = 1;
    b->parts.vertices = b->vertices[0];
    b->parts.edges = b->edges;
    b->parts.uses = b->uses;
    b->parts.loops = b->loops;
    b->parts.faces = b->faces;
    b->parts.shells = b->shells;
    b->parts.is_solid = is_solid;
    b->parts.tolerance = 1e-6;
    CHECK_OK(batten_body_create(&b->parts, &both));
    batten_body_unref(outer);
    batten_body_unref(inner);
    return both;
}

static batten_model *model_of(batten_body *body)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "tank",
                                                      .layer = "7",
                                                      .has_colour = true,
                                                      .colour = {0, 1, 0},
                                                      .kind = BATTEN_OBJECT_BODY,
                                                      .body = body}));
    batten_body_unref(body);
    return model;
}

static batten_write_options whole(void)
{
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_IGES;
    options.solids = true;
    return options;
}

static void write_whole(const batten_model *model, char **data, size_t *size)
{
    const batten_write_options options = whole();
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_write_memory(model, &options, notes, data, size));
    CHECK_INT(batten_notes_count(notes), 0);
    batten_notes_free(notes);
}

/* What is written reads back, and is written the same. */
static batten_model *back_of(const batten_model *model)
{
    batten_model *back = NULL;
    char *first = NULL, *second = NULL;
    size_t size = 0, again = 0;
    write_whole(model, &first, &size);
    CHECK_OK(read_bytes(first, size, BATTEN_FORMAT_IGES, NULL, &back));
    write_whole(back, &second, &again);
    CHECK(size == again && memcmp(first, second, size) == 0);
    batten_release(first);
    batten_release(second);
    return back;
}

static void check_counts(const batten_body_parts *p, int vertices, int edges, int faces,
                         int shells)
{
    CHECK_INT(p->vertex_count, vertices);
    CHECK_INT(p->edge_count, edges);
    CHECK_INT(p->face_count, faces);
    CHECK_INT(p->shell_count, shells);
}

TEST(a_solid_with_a_void_stays_one)
{
    batten_model *model = model_of(two_shells(true)), *back = back_of(model);
    CHECK_INT(batten_model_count(back), 1);
    const batten_object *object = batten_model_object(back, 0);
    const batten_body_parts *p = batten_body_view(object->body);
    batten_body_measures m;
    batten_body_faults faults;
    CHECK_TEXT(object->name, "tank");
    CHECK_TEXT(object->layer, "7");
    CHECK(object->has_colour && object->colour[1] == 1);
    check_counts(p, 8 + DRILLED_VERTICES, 12 + DRILLED_EDGES, 6 + DRILLED_FACES, 2);
    CHECK(p->is_solid);
    CHECK(p->faces[3].has_colour && p->faces[3].colour[0] == 1);
    CHECK_TEXT(p->faces[3].name,
               batten_body_view(batten_model_object(model, 0)->body)->faces[3].name);
    CHECK(p->uses[0].parameters != NULL);
    CHECK_OK(batten_body_measure(object->body, 1e-9, NULL, &m));
    CHECK(m.is_closed);
    CHECK_NEAR(m.volume, 1000 - 48 + 2 * acos(-1), 1e-6);
    CHECK_OK(batten_body_check(object->body, 1e-6, NULL, NULL, &faults));
    CHECK_INT(faults.turned_shells, 0);
    batten_model_unref(model);
    batten_model_unref(back);
}

TEST(shells_of_no_solid_are_written_one_by_one)
{
    batten_model *model = model_of(two_shells(false)), *back = back_of(model);
    CHECK_INT(batten_model_count(back), 2);
    const batten_body_parts *p = batten_body_view(batten_model_object(back, 1)->body);
    check_counts(p, DRILLED_VERTICES, DRILLED_EDGES, DRILLED_FACES, 1);
    CHECK(!p->is_solid && p->shells[0].closed);
    CHECK_TEXT(batten_model_object(back, 1)->group, "tank");
    batten_model_unref(model);
    batten_model_unref(back);
}

/* A ball has a seam and poles, whose uses are vertices. */
TEST(a_ball_that_is_a_solid_stays_one)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *sphere = NULL;
    batten_body *sheet = NULL, *ball = NULL;
    batten_body_measures m;
    CHECK_OK(batten_surface_sphere(&frame, 2, &sphere));
    CHECK_OK(batten_body_from_surface("ball", sphere, 1e-6, &sheet));
    batten_body_parts parts = *batten_body_view(sheet);
    const batten_body_shell closed = {0, 1, true};
    parts.shells = &closed;
    parts.is_solid = true;
    CHECK_OK(batten_body_create(&parts, &ball));
    batten_model *model = model_of(ball), *back = back_of(model);
    const batten_body *made = batten_model_object(back, 0)->body;
    CHECK(batten_body_view(made)->is_solid);
    CHECK_OK(batten_body_measure(made, 1e-9, NULL, &m));
    CHECK_NEAR(m.volume, 32 * acos(-1) / 3, 1e-6);
    batten_body_unref(sheet);
    batten_surface_unref(sphere);
    batten_model_unref(model);
    batten_model_unref(back);
}

TEST(solids_in_what_is_placed_need_no_parts)
{
    batten_model *part = model_of(two_shells(true)), *model = NULL;
    const double point[3] = {1, 2, 3};
    CHECK_OK(batten_model_add(part, &(batten_object){.name = "mark",
                                                     .kind = BATTEN_OBJECT_POINTS,
                                                     .point_count = 1,
                                                     .points = point}));
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(
        batten_model_add(model, &(batten_object){.name = "here",
                                                 .kind = BATTEN_OBJECT_INSTANCE,
                                                 .definition = part,
                                                 .place = batten_affine_translation(5, 6, 7)}));
    batten_model *back = back_of(model);
    CHECK_INT(batten_model_count(back), 1);
    const batten_object *instance = batten_model_object(back, 0);
    CHECK_INT(instance->kind, BATTEN_OBJECT_INSTANCE);
    CHECK_INT(batten_model_count(instance->definition), 2);
    CHECK(batten_body_view(batten_model_object(instance->definition, 0)->body)->is_solid);
    batten_model_unref(part);
    batten_model_unref(model);
    batten_model_unref(back);
}

/* Two sheets of one box, three faces each, that share edges and vertices: each has all of its own
 * when it is read, as lists of 504 and 502 are those of one body. */
TEST(sheets_that_share_edges_have_them_each)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3}), *sheets = NULL;
    batten_body_parts parts = *batten_body_view(box);
    const batten_body_shell shells[2] = {{0, 3, false}, {3, 3, false}};
    parts.is_solid = false;
    parts.shell_count = 2;
    parts.shells = shells;
    CHECK_OK(batten_body_create(&parts, &sheets));
    batten_model *model = model_of(sheets), *back = back_of(model);
    CHECK_INT(batten_model_count(back), 2);
    for (int i = 0; i < 2; i++) {
        const batten_body_parts *p = batten_body_view(batten_model_object(back, i)->body);
        int shared = 0;
        CHECK_INT(p->face_count, 3);
        CHECK_INT(p->use_count, 12);
        for (int e = 0; e < p->edge_count; e++) {
            int count = 0;
            for (int k = 0; k < p->use_count; k++)
                count += p->uses[k].edge == e;
            CHECK(count == 1 || count == 2);
            shared += count == 2;
        }
        CHECK_INT(p->edge_count, 12 - shared);
        CHECK_INT(p->vertex_count, shared == 3 ? 7 : 8);
    }
    batten_body_unref(box);
    batten_model_unref(model);
    batten_model_unref(back);
}
