/* The measures of bodies, meshes and surfaces, as text and as JSON. */
#include "design/shared/solids.h"
#include "base/plural.h"

#include <math.h>

/* ---- pairs of a name and a number ---- */

typedef struct {
    const char *key, *one, *many;
    int count;
} counted;

static void text_counts(batten_text *out, int count, const counted *rows)
{
    bool first = true;
    for (int i = 0; i < count; i++)
        if (rows[i].count) {
            batten_text_add(out, "%s%d %s", first ? "" : ", ", rows[i].count,
                            bat_one_or_many(rows[i].count, rows[i].one, rows[i].many));
            first = false;
        }
}

static void json_counts(batten_text *out, int count, const counted *rows)
{
    for (int i = 0; i < count; i++)
        batten_text_add(out, ", \"%s\": %d", rows[i].key, rows[i].count);
}

static void json_number(batten_text *out, const char *key, double value)
{
    batten_text_add(out, ", \"%s\": ", key);
    batten_text_number(out, value);
}

static void json_numbers(batten_text *out, const char *key, const double values[3])
{
    batten_text_add(out, ", \"%s\": [", key);
    for (int k = 0; k < 3; k++) {
        batten_text_add(out, k ? ", " : "");
        batten_text_number(out, values[k]);
    }
    batten_text_add(out, "]");
}

/* ", "box": [[0, 0, 0], [1, 2, 3]]" */
static void json_box(batten_text *out, const batten_box *box)
{
    const double low[3] = {box->low.x, box->low.y, box->low.z};
    const double high[3] = {box->high.x, box->high.y, box->high.z};
    for (int k = 0; k < 6; k++) {
        batten_text_add(out, k == 0 ? ", \"box\": [[" : k == 3 ? "], [" : ", ");
        batten_text_number(out, k < 3 ? low[k] : high[k - 3]);
    }
    batten_text_add(out, "]]");
}

static void text_box(batten_text *out, const batten_box *box)
{
    batten_text_add(out, "  box %.9g %.9g %.9g  to  %.9g %.9g %.9g", box->low.x, box->low.y,
                    box->low.z, box->high.x, box->high.y, box->high.z);
}

/* `error`: so far the sides may be from the shape. */
static void add_box(batten_text *out, const batten_box *box, double error, bool json)
{
    if (!json) {
        text_box(out, box);
        if (error > 0)
            batten_text_add(out, " (error at most %.3g)", error);
        batten_text_add(out, "\n");
        return;
    }
    json_box(out, box);
    json_number(out, "box_error", error);
}

/* ---- measures ---- */

/* What bodies and meshes have both. */
typedef struct {
    const char *kind;
    bool is_closed;
    double area, volume, area_error, volume_error;
    const double *centroid;
    batten_box box;
    double box_error;
} extent;

static void add_extent(const batten_object *object, const extent *e, bool json,
                       batten_text *out)
{
    if (json) {
        batten_text_add(out, "    {\"name\": ");
        batten_text_json(out, object->name);
        batten_text_add(out, ", \"type\": \"%s\", \"closed\": %s", e->kind,
                        e->is_closed ? "true" : "false");
        json_number(out, "area", e->area);
        json_number(out, "area_error", e->area_error);
        json_number(out, "volume", e->volume);
        json_number(out, "volume_error", e->volume_error);
        json_numbers(out, "centroid", e->centroid);
    } else {
        batten_text_add(out, "%s: %s, %s, area %.9g", object->name, e->kind,
                        e->is_closed ? "closed" : "not closed", e->area);
        if (e->area_error > 0)
            batten_text_add(out, " (error at most %.3g)", e->area_error);
        if (e->is_closed)
            batten_text_add(out, ", volume %.9g", e->volume);
        if (e->is_closed && e->volume_error > 0)
            batten_text_add(out, " (error at most %.3g)", e->volume_error);
        batten_text_add(out, "\n  centroid of the %s %.9g %.9g %.9g\n",
                        e->is_closed ? "volume" : "area", e->centroid[0], e->centroid[1],
                        e->centroid[2]);
    }
    add_box(out, &e->box, e->box_error, json);
}

static batten_status measure_body(bat_run *run, const batten_object *object, bool json,
                                  batten_text *out)
{
    const batten_body_parts *parts = batten_body_view(object->body);
    batten_body_measures m = {.area = 0};
    /* Relative: nine digits of areas and volumes, with the bound beside them. */
    batten_status status = batten_body_measure(object->body, 1e-9, run->job, &m);
    if (status == BATTEN_TOLERANCE_NOT_MET) {
        bat_note(run, "'%.60s': %s", object->name, batten_message());
        status = BATTEN_OK;
    }
    if (status != BATTEN_OK)
        return status;
    run->partly = run->partly || m.unmeasured > 0;
    const extent e = {.kind = "body",
                      .is_closed = m.is_closed,
                      .area = m.area,
                      .volume = m.volume,
                      .area_error = m.area_error,
                      .volume_error = m.volume_error,
                      .centroid = m.centroid,
                      .box = m.box,
                      .box_error = m.box_error};
    const counted rows[] = {{"shells", "shell", "shells", parts->shell_count},
                            {"faces", "face", "faces", parts->face_count},
                            {"edges", "edge", "edges", parts->edge_count},
                            {"vertices", "vertex", "vertices", parts->vertex_count}};
    add_extent(object, &e, json, out);
    if (json) {
        json_number(out, "edge_length", m.edge_length);
        if (m.unmeasured > 0)
            json_number(out, "unmeasured_faces", m.unmeasured);
        json_counts(out, 4, rows);
        batten_text_add(out, "}");
        return BATTEN_OK;
    }
    batten_text_add(out, "  ");
    text_counts(out, 4, rows);
    batten_text_add(out, "; length of all edges %.9g\n", m.edge_length);
    return BATTEN_OK;
}

static batten_status measure_mesh(const batten_object *object, bool json, batten_text *out)
{
    const batten_mesh_parts *parts = batten_mesh_view(object->mesh);
    batten_mesh_facts f;
    const batten_status status = batten_mesh_check(object->mesh, &f);
    if (status != BATTEN_OK)
        return status;
    const extent e = {.kind = "mesh",
                      .is_closed = f.is_watertight,
                      .area = f.area,
                      .volume = f.volume,
                      .centroid = f.centroid,
                      .box = batten_mesh_box(object->mesh)};
    const counted rows[] = {{"triangles", "triangle", "triangles", parts->triangle_count},
                            {"vertices", "vertex", "vertices", parts->vertex_count},
                            {"edges", "edge", "edges", f.edges},
                            {"pieces", "piece", "pieces", f.pieces},
                            {"rim_edges", "edge at the rim", "edges at the rim", f.rim_edges},
                            {"wrong_edges", "edge between triangles turned against each other",
                             "edges between triangles turned against each other",
                             f.wrong_edges},
                            {"crowded_edges", "edge of more than two triangles",
                             "edges of more than two triangles", f.crowded_edges}};
    add_extent(object, &e, json, out);
    if (json) {
        json_counts(out, 7, rows);
        batten_text_add(out, "}");
        return BATTEN_OK;
    }
    batten_text_add(out, "  ");
    text_counts(out, 4, rows);
    if (!f.is_watertight && f.edges > 0) {
        batten_text_add(out, "\n  not closed for ");
        text_counts(out, 3, rows + 4);
    }
    batten_text_add(out, "\n");
    return BATTEN_OK;
}

/* ---- points ---- */

static batten_box box_of_points(const batten_object *object)
{
    batten_box box = {{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < object->point_count; i++) {
        const double *p = object->points + 3 * (size_t)i;
        if (i == 0)
            box = (batten_box){{p[0], p[1], p[2]}, {p[0], p[1], p[2]}};
        box.low =
            (batten_vec3){fmin(box.low.x, p[0]), fmin(box.low.y, p[1]), fmin(box.low.z, p[2])};
        box.high = (batten_vec3){fmax(box.high.x, p[0]), fmax(box.high.y, p[1]),
                                 fmax(box.high.z, p[2])};
    }
    return box;
}

void bat_measure_points(const batten_object *object, bool json, batten_text *out)
{
    const batten_offset_table *table = object->offset_table;
    const batten_box box = table ? batten_offset_table_box(table) : box_of_points(object);
    const int stations = table ? batten_offset_table_station_count(table) : 0;
    int count = table ? 0 : object->point_count;
    for (int i = 0; i < stations; i++)
        count += batten_offset_table_station(table, i)->point_count;
    const counted rows[] = {
        {"count", "point", "points", count},
        {"stations", "station", "stations", stations},
        {"lines", "line", "lines", table ? batten_offset_table_line_count(table) : 0}};
    if (json) {
        batten_text_add(out, "    {\"name\": ");
        batten_text_json(out, object->name);
        batten_text_add(out, ", \"type\": \"%s\"", table ? "offsets" : "points");
        json_counts(out, table ? 3 : 1, rows);
        json_box(out, &box);
        batten_text_add(out, "}");
        return;
    }
    batten_text_add(out, "%s: %s", object->name, table ? "table of offsets, " : "");
    text_counts(out, 3, rows);
    batten_text_add(out, "\n");
    text_box(out, &box);
    batten_text_add(out, "\n");
}

batten_status bat_measure_solid(bat_run *run, const batten_object *object, bool json,
                                batten_text *out)
{
    return object->kind == BATTEN_OBJECT_BODY ? measure_body(run, object, json, out)
                                              : measure_mesh(object, json, out);
}

/* ---- faults ---- */

batten_status bat_check_solid(const bat_run *run, const batten_object *object, double tolerance,
                              bat_solid_faults *out)
{
    *out = (bat_solid_faults){.tolerance = tolerance};
    if (object->kind == BATTEN_OBJECT_MESH)
        return batten_mesh_check(object->mesh, &out->mesh);
    if (!(tolerance > 0))
        out->tolerance = batten_body_view(object->body)->tolerance;
    return batten_body_check(object->body, out->tolerance, run->job, run->notes, &out->body);
}

bool bat_solid_holds(const batten_object *object, const bat_solid_faults *faults)
{
    const batten_body_faults *b = &faults->body;
    const batten_mesh_facts *m = &faults->mesh;
    if (object->kind == BATTEN_OBJECT_MESH)
        return m->is_watertight;
    return !b->wrong_edges && !b->crowded_edges && !b->gaps && !b->loose &&
           !b->crossing_loops && !b->open_shells && !b->turned_shells;
}

enum { BODY_ROWS = 13, MESH_ROWS = 6 };

static void body_rows(const batten_body_faults *b, counted rows[BODY_ROWS])
{
    const counted all[BODY_ROWS] = {
        {"shared_edges", "shared edge", "shared edges", b->shared_edges},
        {"free_edges", "free edge", "free edges", b->free_edges},
        {"wrong_edges", "edge between faces turned against each other",
         "edges between faces turned against each other", b->wrong_edges},
        {"crowded_edges", "edge of more than two faces", "edges of more than two faces",
         b->crowded_edges},
        {"tiny_edges", "edge shorter than that", "edges shorter than that", b->tiny_edges},
        {"gaps", "end that misses its vertex", "ends that miss their vertices", b->gaps},
        {"loose", "edge off its face", "edges off their faces", b->loose},
        {"crossing_loops", "loop that crosses", "loops that cross", b->crossing_loops},
        {"poles", "pole", "poles", b->poles},
        {"seams", "seam", "seams", b->seams},
        {"close_knots", "curve or surface with close knots",
         "curves and surfaces with close knots", b->close_knots},
        {"open_shells", "shell marked as closed that is open",
         "shells marked as closed that are open", b->open_shells},
        {"turned_shells", "shell turned inside out", "shells turned inside out",
         b->turned_shells}};
    for (int i = 0; i < BODY_ROWS; i++)
        rows[i] = all[i];
}

static void mesh_rows(const batten_mesh_facts *m, counted rows[MESH_ROWS])
{
    const counted all[MESH_ROWS] = {
        {"rim_edges", "edge at the rim", "edges at the rim", m->rim_edges},
        {"wrong_edges", "edge between triangles turned against each other",
         "edges between triangles turned against each other", m->wrong_edges},
        {"crowded_edges", "edge of more than two triangles", "edges of more than two triangles",
         m->crowded_edges},
        {"flat_triangles", "triangle without area", "triangles without area",
         m->flat_triangles},
        {"loose_vertices", "vertex of no triangle", "vertices of no triangle",
         m->loose_vertices},
        {"pieces", "piece", "pieces", m->pieces}};
    for (int i = 0; i < MESH_ROWS; i++)
        rows[i] = all[i];
}

static void text_mesh(const bat_solid_faults *faults, batten_text *out)
{
    counted rows[MESH_ROWS];
    mesh_rows(&faults->mesh, rows);
    batten_text_add(out, "%s; ", faults->mesh.is_watertight ? "closed" : "not closed");
    text_counts(out, MESH_ROWS, rows);
}

static void text_body(const bat_solid_faults *faults, batten_text *out)
{
    counted rows[BODY_ROWS];
    body_rows(&faults->body, rows);
    batten_text_add(out, "within %.3g: ", faults->tolerance);
    text_counts(out, BODY_ROWS, rows);
    if (faults->body.gaps)
        batten_text_add(out, "; gaps up to %.3g", faults->body.largest_gap);
    if (faults->body.loose)
        batten_text_add(out, "; edges up to %.3g off", faults->body.largest_miss);
}

void bat_solid_text(const batten_object *object, const bat_solid_faults *faults,
                    batten_text *out)
{
    batten_text_add(out, "    ");
    if (object->kind == BATTEN_OBJECT_MESH)
        text_mesh(faults, out);
    else
        text_body(faults, out);
    batten_text_add(out, "\n");
}

static void json_mesh(const bat_solid_faults *faults, batten_text *out)
{
    counted rows[MESH_ROWS];
    mesh_rows(&faults->mesh, rows);
    batten_text_add(out, ", \"closed\": %s", faults->mesh.is_watertight ? "true" : "false");
    json_counts(out, MESH_ROWS, rows);
}

static void json_body(const bat_solid_faults *faults, batten_text *out)
{
    counted rows[BODY_ROWS];
    body_rows(&faults->body, rows);
    json_number(out, "tolerance", faults->tolerance);
    json_counts(out, BODY_ROWS, rows);
    json_number(out, "largest_gap", faults->body.largest_gap);
    json_number(out, "largest_miss", faults->body.largest_miss);
}

void bat_solid_json(const batten_object *object, const bat_solid_faults *faults,
                    batten_text *out)
{
    batten_text_add(out, ", \"holds\": %s", bat_solid_holds(object, faults) ? "true" : "false");
    if (object->kind == BATTEN_OBJECT_MESH)
        json_mesh(faults, out);
    else
        json_body(faults, out);
}

batten_status bat_check_within(const bat_run *run)
{
    if (!bat_has(run, "within") || bat_number(run, "within") > 0)
        return BATTEN_OK;
    return bat_fail(BATTEN_BAD_ARGUMENT, "'within' is %g; it must be above 0",
                    bat_number(run, "within"));
}
