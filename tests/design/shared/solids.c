#include "design/shared/solids.h"
#include "design/expect.h"
#include "support/bodies.h"

#include <batten/exchange.h>

/* A box 3 x 2 x 1, whose measures are known: as a body, as a mesh, and as points. */

static void write_box(void)
{
    batten_model *model = NULL;
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){3, 2, 1});
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){
                   .name = "block", .layer = "", .kind = BATTEN_OBJECT_BODY, .body = box}));
    CHECK_OK(batten_write_file(model, test_scratch("box.step"), NULL, NULL));
    batten_model_unref(model);
    batten_body_unref(box);
    FILE *file = fopen(test_scratch("table.csv"), "w");
    CHECK(file != NULL);
    fputs("x_m,z_m,half_breadth_m,line\n0,1,2,a\n0,3,4,b\n5,1,6,a\n5,3,7,b\n", file);
    fclose(file);
}

TEST(a_box_has_its_area_volume_centroid_and_counts)
{
    static const char solids[] =
        "  block: {read: box.step}\n"
        "  table: {read: table.csv}\n"
        "  mesh: {mesh: block}\n"
        "  net: {points: [[0, 0, 0], [3, 0, 0], [0, 2, 0], [3, 2, 0]], columns: 2}\n"
        "  sheet: {bezier-surface: net}\n"
        "  open: {mesh: sheet}\n"
        "  row: {points: [[3, 1, 2], [-1, 5, 0], [2, -4, 7]]}\n"
        "  lone: {points: [[3, 1, 2]]}\n";
    static const expect_row rows[] = {
        {"m.txt: {measure: block}", BATTEN_OK,
         "block: body, closed, area 22|, volume 6|\n  centroid of the volume 1.5 1 0.5\n  box 0 0 0  to  3 2 1\n  1 shell, 6 faces, 12 "
         "edges, 8 vertices; length of all edges 24\n"},
        {"m.json: {measure: block}", BATTEN_OK,
         "\"type\": \"body\", \"closed\": true, \"area\": 2|, \"area_error\": |, \"volume\": |, \"volume_error\": |, \"centroid\": [1.5|, "
         "\"box\": [[|\"box_error\": |, \"edge_length\": 24, \"shells\": 1, \"faces\": 6, \"edges\": 12, \"vertices\": "
         "8}|!unmeasured"},
        {"m.txt: {measure: mesh}", BATTEN_OK,
         "mesh, closed, area 22, volume 6\n  centroid of the volume 1.5 1 0.5\n  box 0 0 0  to  3 2 1\n  12 triangles, 8 vertices, 18 "
         "edges, 1 piece\n|!not closed"},
        {"m.txt: {measure: open}", BATTEN_OK,
         "mesh, not closed, area 6\n  centroid of the area 1.5 1 0\n|2 triangles, 4 vertices, 5 edges, 1 piece\n  not closed for 4 edges "
         "at the rim\n"},
        {"m.json: {measure: mesh}", BATTEN_OK,
         "\"type\": \"mesh\", \"closed\": true, \"area\": 22, |\"volume\": 6|\"centroid\": [1.5, 1, 0.5]|\"triangles\": 12, \"vertices\": 8, "
         "\"edges\": 18, \"pieces\": 1, \"rim_edges\": 0, \"wrong_edges\": 0, \"crowded_edges\": 0}"},
        {"m.txt: {measure: row}", BATTEN_OK, "row: 3 points\n  box -1 -4 0  to  3 5 7\n"},
        {"m.txt: {measure: lone}", BATTEN_OK, "lone: 1 point\n  box 3 1 2  to  3 1 2\n"},
        {"m.json: {measure: row}", BATTEN_OK,
         "\"type\": \"points\", \"count\": 3, \"box\": [[-1, -4, 0], [3, 5, 7]]}"},
        {"m.txt: {measure: table}", BATTEN_OK,
         "table of offsets, 4 points, 2 stations, 2 lines\n  box 0 2 1  to  5 7 3\n"},
        {"m.json: {measure: table}", BATTEN_OK,
         "\"type\": \"offsets\", \"count\": 4, \"stations\": 2, \"lines\": 2, \"box\": [[0, 2, 1], [5, 7, 3]]}"},
        {"k.txt: {check: block}", BATTEN_OK,
         "What was done\n  block (read)\n|block (body)\n    within 1e-06: 12 shared edges\n"},
        {"k.txt: {check: block}", BATTEN_OK, "No verdict: "},
        {"k.json: {check: block}", BATTEN_OK, "\"ok\": true"},
        {"k.txt: {check: open}", BATTEN_OK, "not closed"},
        {"k.json: {check: [block, mesh], within: 0.001}", BATTEN_OK, "\"ok\": true"},
        {"k.json: {check: open, within: 0.001}", BATTEN_OK, "\"ok\": false"},
    };
    write_box();
    EXPECT_OUTPUTS(solids, rows);
}

/* ---- faults ---- */

static void set_fault(batten_body_faults *f, int which, int count)
{
    int *const all[] = {&f->shared_edges, &f->free_edges, &f->wrong_edges, &f->crowded_edges,
                        &f->tiny_edges,   &f->gaps,       &f->loose,       &f->crossing_loops,
                        &f->poles,        &f->seams,      &f->close_knots, &f->open_shells,
                        &f->turned_shells};
    *all[which] = count;
}

static const struct {
    const char *one, *two, *key;
    bool holds;
} faults_of_bodies[] = {
    {"1 shared edge", "2 shared edges", "shared_edges", true},
    {"1 free edge", "2 free edges", "free_edges", true},
    {"1 edge between faces turned against each other",
     "2 edges between faces turned against each other", "wrong_edges", false},
    {"1 edge of more than two faces", "2 edges of more than two faces", "crowded_edges", false},
    {"1 edge shorter than that", "2 edges shorter than that", "tiny_edges", true},
    {"1 end that misses its vertex; gaps up to 0.25",
     "2 ends that miss their vertices; gaps up to 0.25", "gaps", false},
    {"1 edge off its face; edges up to 0.5 off", "2 edges off their faces; edges up to 0.5 off",
     "loose", false},
    {"1 loop that crosses", "2 loops that cross", "crossing_loops", false},
    {"1 pole", "2 poles", "poles", true},
    {"1 seam", "2 seams", "seams", true},
    {"1 curve or surface with close knots", "2 curves and surfaces with close knots",
     "close_knots", true},
    {"1 shell marked as closed that is open", "2 shells marked as closed that are open",
     "open_shells", false},
    {"1 shell turned inside out", "2 shells turned inside out", "turned_shells", false}};

static void check_texts(const batten_object *object, const bat_solid_faults *faults,
                        const char *text, const char *json)
{
    batten_text said = BATTEN_TEXT, written = BATTEN_TEXT;
    bat_solid_text(object, faults, &said);
    bat_solid_json(object, faults, &written);
    if (!said.failed)
        CHECK_TEXT(said.bytes, text);
    if (!written.failed)
        CHECK_CONTAINS(written.bytes, json);
    batten_text_free(&said);
    batten_text_free(&written);
}

TEST(each_fault_of_a_body_has_its_words_and_its_verdict)
{
    const batten_object body = {.name = "b", .kind = BATTEN_OBJECT_BODY};
    for (int k = 0; k < COUNT(faults_of_bodies); k++)
        for (int count = 1; count <= 2; count++) {
            bat_solid_faults faults = {.tolerance = 0.125};
            char text[200], json[200];
            faults.body.largest_gap = 0.25;
            faults.body.largest_miss = 0.5;
            set_fault(&faults.body, k, count);
            CHECK(bat_solid_holds(&body, &faults) == faults_of_bodies[k].holds);
            snprintf(text, sizeof text, "    within 0.125: %s\n",
                     count == 1 ? faults_of_bodies[k].one : faults_of_bodies[k].two);
            snprintf(json, sizeof json, "\"%s\": %d", faults_of_bodies[k].key, count);
            check_texts(&body, &faults, text, json);
            snprintf(json, sizeof json,
                     ", \"holds\": %s, \"tolerance\": 0.125, \"shared_edges\": ",
                     faults_of_bodies[k].holds ? "true" : "false");
            check_texts(&body, &faults, text, json);
            check_texts(&body, &faults, text, ", \"largest_gap\": 0.25, \"largest_miss\": 0.5");
        }
}

TEST(a_mesh_holds_when_it_is_closed)
{
    const batten_object mesh = {.name = "m", .kind = BATTEN_OBJECT_MESH};
    for (int closed = 0; closed < 2; closed++) {
        bat_solid_faults faults = {.tolerance = 0.125};
        faults.mesh.is_watertight = closed;
        faults.mesh.pieces = 1;
        faults.mesh.flat_triangles = 2;
        CHECK(bat_solid_holds(&mesh, &faults) == closed);
        check_texts(&mesh, &faults,
                    closed ? "    closed; 2 triangles without area, 1 piece\n"
                           : "    not closed; 2 triangles without area, 1 piece\n",
                    closed ? ", \"holds\": true, \"closed\": true, \"rim_edges\": 0, "
                             "\"wrong_edges\": 0, \"crowded_edges\": 0, \"flat_triangles\": 2, "
                             "\"loose_vertices\": 0, \"pieces\": 1"
                           : ", \"holds\": false, \"closed\": false, \"rim_edges\": 0");
    }
}
