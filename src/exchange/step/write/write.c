/* A model as a STEP file: a product for the model and for each that it places. */
#include "base/real.h"
#include "exchange/formats.h"
#include "exchange/shapes/prepare.h"
#include "exchange/step/write/writing.h"

#include <string.h>

/* ---- objects ---- */

/* What is of one model: items of each kind of representation. */
typedef struct {
    bat_step_bag solids, sheets, curves, meshes, places;
} contents;

static void contents_end(contents *c)
{
    bat_release(c->solids.ids);
    bat_release(c->sheets.ids);
    bat_release(c->curves.ids);
    bat_release(c->meshes.ids);
    bat_release(c->places.ids);
}

static batten_status mark_faces(bat_step_writing *w, const batten_body_parts *parts,
                                const int *faces)
{
    batten_status status = BATTEN_OK;
    for (int f = 0; status == BATTEN_OK && f < parts->face_count; f++)
        if (faces[f] && parts->faces[f].has_colour)
            status =
                bat_step_put_colour(w, BATTEN_OBJECT_BODY, parts->faces[f].colour, faces[f]);
    return status;
}

static batten_status write_body(bat_step_writing *w, const batten_object *object, contents *c)
{
    batten_body *body = NULL;
    int id = 0;
    batten_status status =
        bat_prepare_body(object, w->step.tolerance, w->unit_metres, w->step.notes, &body);
    if (status != BATTEN_OK)
        return status;
    const batten_body_parts *parts = batten_body_view(body);
    int *faces = bat_array((size_t)parts->face_count, sizeof *faces);
    status =
        faces ? bat_step_body(&w->step, object->name, body, faces, &id) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && id)
        status = bat_step_bag_add(parts->is_solid ? &c->solids : &c->sheets, id);
    if (status == BATTEN_OK && id)
        status = bat_step_mark(w, object, id);
    if (status == BATTEN_OK)
        status = mark_faces(w, parts, faces);
    bat_release(faces);
    batten_body_unref(body);
    return status;
}

static batten_status write_curve(bat_step_writing *w, const batten_object *object, contents *c)
{
    batten_curve *curve = NULL;
    batten_status status = bat_prepare_curve(object, &curve);
    if (status != BATTEN_OK)
        return status;
    const int id = bat_step_curve(&w->step, object->name, curve, NULL);
    batten_curve_unref(curve);
    const int set = bat_step_list(&w->step, "GEOMETRIC_CURVE_SET", object->name, &id, 1);
    status = bat_step_bag_add(&c->curves, set);
    return status == BATTEN_OK ? bat_step_mark(w, object, id) : status;
}

static int put_set(bat_step *step, const batten_object *object)
{
    const int first = bat_step_points(step, 3, object->points, (size_t)object->point_count);
    const int set = bat_step_open(step, "GEOMETRIC_CURVE_SET");
    bat_step_string(step, object->name, ",(");
    bat_step_range(step, first, object->point_count, ")");
    bat_step_close(step);
    return set;
}

static batten_status write_points(bat_step_writing *w, const batten_object *object, contents *c)
{
    if (object->point_count == 0)
        return BATTEN_OK;
    const int set = put_set(&w->step, object);
    const batten_status status = bat_step_bag_add(&c->curves, set);
    return status == BATTEN_OK ? bat_step_mark(w, object, set) : status;
}

/* Of a schema that has meshes; from a model for another one they were taken out before. */
static batten_status write_mesh(bat_step_writing *w, const batten_object *object, contents *c)
{
    if (batten_mesh_view(object->mesh)->triangle_count == 0)
        return BATTEN_OK;
    const int id = bat_step_put_mesh(&w->step, object->name, object->mesh);
    const batten_status status = bat_step_bag_add(&c->meshes, id);
    return status == BATTEN_OK ? bat_step_mark(w, object, id) : status;
}

/* Objects go in the order of the representations, so that what is read has it too. */
enum { SOLIDS, SHEETS, CURVES, MESHES, KINDS };

static int kind_of(const batten_object *object)
{
    switch (object->kind) {
    case BATTEN_OBJECT_SURFACE:
        return SHEETS;
    case BATTEN_OBJECT_BODY:
        return batten_body_view(object->body)->is_solid ? SOLIDS : SHEETS;
    case BATTEN_OBJECT_CURVE:
    case BATTEN_OBJECT_POINTS:
        return CURVES;
    case BATTEN_OBJECT_MESH:
        return MESHES;
    default: /* instances; what the format does not hold was taken out before */
        return KINDS;
    }
}

static batten_status write_object(bat_step_writing *w, const batten_object *object, contents *c)
{
    if (w->step.count > 1000000000)
        return bat_fail(BATTEN_TOO_LARGE, "a STEP file has room for 1000000000 instances");
    switch (object->kind) {
    case BATTEN_OBJECT_SURFACE:
    case BATTEN_OBJECT_BODY:
        return write_body(w, object, c);
    case BATTEN_OBJECT_CURVE:
        return write_curve(w, object, c);
    case BATTEN_OBJECT_POINTS:
        return write_points(w, object, c);
    default:
        return write_mesh(w, object, c);
    }
}

static batten_status write_objects(bat_step_writing *w, const batten_model *model, contents *c)
{
    batten_status status = BATTEN_OK;
    for (int kind = 0; kind < KINDS; kind++)
        for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++)
            if (kind_of(batten_model_object(model, i)) == kind)
                status = write_object(w, batten_model_object(model, i), c);
    return status;
}

/* ---- representations ---- */

static int put_representation(bat_step_writing *w, const char *keyword, const char *name,
                              int origin, const bat_step_bag *items)
{
    bat_step *step = &w->step;
    const int id = bat_step_open(step, keyword);
    bat_step_string(step, name, ",(");
    bat_step_id(step, origin, items->count ? "," : "),");
    bat_step_ids(step, items->ids, items->count, "),");
    bat_step_id(step, w->context, "");
    bat_step_close(step);
    return id;
}

/* Solids, sheets, curves and meshes need representations of their own; where there are
 * several, or none, or where others are placed, a further one holds them together. */
static void put_representations(bat_step_writing *w, const char *name, const contents *c,
                                bat_step_node *node)
{
    const struct {
        const char *keyword;
        const bat_step_bag *items;
    } kinds[] = {{"ADVANCED_BREP_SHAPE_REPRESENTATION", &c->solids},
                 {"MANIFOLD_SURFACE_SHAPE_REPRESENTATION", &c->sheets},
                 {"GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION", &c->curves},
                 {"TESSELLATED_SHAPE_REPRESENTATION", &c->meshes}};
    bat_step *step = &w->step;
    int ids[KINDS], count = 0;
    for (int k = 0; k < KINDS; k++)
        if (kinds[k].items->count)
            ids[count++] =
                put_representation(w, kinds[k].keyword, name, node->origin, kinds[k].items);
    node->representation = ids[0];
    if (count != 1 || c->places.count) {
        node->representation =
            put_representation(w, "SHAPE_REPRESENTATION", name, node->origin, &c->places);
        for (int k = 0; k < count; k++)
            bat_step_add(step, "SHAPE_REPRESENTATION_RELATIONSHIP", "'','',#%d,#%d",
                         node->representation, ids[k]);
    }
    const int shape =
        bat_step_add(step, "PRODUCT_DEFINITION_SHAPE", "'','',#%d", node->definition);
    bat_step_add(step, "SHAPE_DEFINITION_REPRESENTATION", "#%d,#%d", shape,
                 node->representation);
}

/* ---- assemblies ---- */

bool bat_step_can_place(const batten_affine *place)
{
    const double tolerance = 1e-12;
    double dot[3][3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            dot[i][k] = place->m[0][i] * place->m[0][k] + place->m[1][i] * place->m[1][k] +
                        place->m[2][i] * place->m[2][k];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            if (!(fabs(dot[i][k] - (i == k)) <= tolerance))
                return false;
    const double(*m)[3] = place->m;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
               m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) >
           0;
}

/* The place as an item of the representation, to which it belongs. */
static batten_status put_place(bat_step_writing *w, const batten_object *object, contents *c)
{
    const double(*m)[3] = object->place.m;
    const double z[] = {m[0][2], m[1][2], m[2][2]}, x[] = {m[0][0], m[1][0], m[2][0]};
    return bat_step_bag_add(&c->places, bat_step_placement(&w->step, object->place.t, z, x));
}

/* That the definition is placed in the node. */
static void put_occurrence(bat_step_writing *w, const batten_object *object, int place,
                           const bat_step_node *node)
{
    bat_step *step = &w->step;
    const bat_step_node *part = &w->nodes[bat_definitions_index(&w->parts, object->definition)];
    const int use = bat_step_open(step, "NEXT_ASSEMBLY_USAGE_OCCURRENCE");
    char number[BAT_INTEGER_SIZE];
    bat_integer_write(++w->occurrences, number);
    bat_step_string(step, number, ",");
    bat_step_string(step, object->name, ",'',");
    bat_step_id(step, node->definition, ",");
    bat_step_id(step, part->definition, ",$");
    bat_step_close(step);
    const int shape = bat_step_add(step, "PRODUCT_DEFINITION_SHAPE", "'','',#%d", use);
    const int transformation =
        bat_step_add(step, "ITEM_DEFINED_TRANSFORMATION", "'','',#%d,#%d", part->origin, place);
    const int relation = bat_step_open(step, "");
    bat_step_token(step, "REPRESENTATION_RELATIONSHIP('','',");
    bat_step_id(step, part->representation, ",");
    bat_step_id(step, node->representation, ") ");
    bat_step_token(step, "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(");
    bat_step_id(step, transformation, ") ");
    bat_step_token(step, "SHAPE_REPRESENTATION_RELATIONSHIP()");
    bat_step_close(step);
    bat_step_add(step, "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION", "#%d,#%d", relation, shape);
}

/* ---- models ---- */

/* The product of a model whose instances have theirs. */
static batten_status write_product(void *context, int index, const char *called)
{
    bat_step_writing *w = context;
    static const double origin[] = {0, 0, 0}, z[] = {0, 0, 1}, x[] = {1, 0, 0};
    const batten_model *model = w->parts.models[index];
    const char *name = w->names[index];
    bat_step_node *node = &w->nodes[index];
    contents c = {0};
    batten_text id = BATTEN_TEXT;
    (void)called;
    batten_status status = bat_step_add_product_id(w, index, &id);
    if (status == BATTEN_OK)
        status = bat_step_put_product(w, id.bytes, name, &node->definition);
    batten_text_free(&id);
    node->origin = bat_step_placement(&w->step, origin, z, x);
    if (status == BATTEN_OK)
        status = write_objects(w, model, &c);
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++)
        if (batten_model_object(model, i)->kind == BATTEN_OBJECT_INSTANCE)
            status = put_place(w, batten_model_object(model, i), &c);
    if (status == BATTEN_OK)
        put_representations(w, name, &c, node);
    for (int i = 0, k = 0; status == BATTEN_OK && i < batten_model_count(model); i++)
        if (batten_model_object(model, i)->kind == BATTEN_OBJECT_INSTANCE)
            put_occurrence(w, batten_model_object(model, i), c.places.ids[k++], node);
    contents_end(&c);
    return status;
}

/* ---- the file ---- */

static const char *schema_name(batten_step_schema schema)
{
    switch (schema) {
    case BATTEN_STEP_AP203:
        return "CONFIG_CONTROL_DESIGN";
    case BATTEN_STEP_AP242:
        return "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }";
    case BATTEN_STEP_AP214:
        break;
    }
    return "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }";
}

static void put_header(bat_step *step, const batten_write_options *options)
{
    batten_text_add(step->text, "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n");
    step->line = step->text->length;
    bat_step_token(step, "FILE_NAME(");
    bat_step_string(step, options->name, ",");
    bat_step_string(step, options->date ? options->date : BAT_STEP_NEUTRAL_DATE, ",(''),(''),");
    batten_text_add(step->text, "'Batten %s','Batten','');\n", batten_version());
    batten_text_add(step->text, "FILE_SCHEMA(('%s'));\nENDSEC;\nDATA;\n",
                    schema_name(options->schema));
    step->line = step->text->length;
}

static batten_status write_all(bat_step_writing *w, const batten_model *model)
{
    bat_text_reserve(w->step.text, 100 * bat_count_points(model)); /* mostly enough */
    put_header(&w->step, w->options);
    bat_step_put_contexts(w, batten_model_unit_metres(model));
    w->nodes = bat_array((size_t)w->parts.count, sizeof *w->nodes);
    batten_status status = w->nodes ? bat_step_name_products(w) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_definitions_each(&w->parts, write_product, w);
    if (status == BATTEN_OK)
        status = bat_step_put_marks(w);
    if (status == BATTEN_OK) {
        if (w->options->schema == BATTEN_STEP_AP203)
            bat_step_put_management(w);
        batten_text_add(w->step.text, "ENDSEC;\nEND-ISO-10303-21;\n");
    }
    return status;
}

static void end_writing(bat_step_writing *w)
{
    bat_definitions_end(&w->parts);
    bat_release(w->nodes);
    bat_release(w->names);
    bat_release(w->numbers);
    bat_release(w->products.ids);
    bat_release(w->formations.ids);
    bat_release(w->definitions.ids);
    bat_release(w->styled.ids);
    bat_release(w->hidden.ids);
    bat_members_end(&w->layers);
    bat_members_end(&w->groups);
}

batten_status bat_write_step(const batten_model *model, const batten_write_options *options,
                             batten_notes *notes, batten_text *text)
{
    batten_model *scaled = NULL;
    batten_status status = BATTEN_OK;
    if (options->schema != BATTEN_STEP_AP214 && options->schema != BATTEN_STEP_AP203 &&
        options->schema != BATTEN_STEP_AP242)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown STEP schema %d", (int)options->schema);
    if (batten_model_unit_metres(model) > 0) {
        scaled = batten_model_ref(model);
    } else {
        batten_notes_add(notes, "", 0, "", "the model has no unit; written as mm");
        status = batten_model_to_unit(model, 0.001, &scaled);
    }
    if (status != BATTEN_OK)
        return status;
    bat_step_writing w = {.step = {.text = text,
                                   .notes = notes,
                                   .has_parameter_curves = !options->no_parameter_curves},
                          .options = options,
                          .unit_metres = batten_model_unit_metres(scaled),
                          .is_bare = options->schema == BATTEN_STEP_AP203};
    status = bat_definitions_find(scaled, &w.parts);
    if (status == BATTEN_OK) {
        w.step.tolerance = bat_step_accuracy(&w.parts, options);
        status = write_all(&w, scaled);
    }
    end_writing(&w);
    batten_model_unref(scaled);
    return status;
}
