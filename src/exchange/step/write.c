#include "exchange/prepare.h"
#include "exchange/step/step.h"

#include <batten/units.h>
#include <string.h>

/* A list of ids that grows. */
typedef struct {
    int *ids;
    int count, capacity;
} id_list;

static batten_status add_id(id_list *list, int id)
{
    if (list->count == list->capacity) {
        const int capacity = bat_max_int(16, 2 * list->capacity);
        int *ids = bat_resize(list->ids, (size_t)capacity, sizeof *ids);
        if (!ids)
            return BATTEN_OUT_OF_MEMORY;
        list->ids = ids;
        list->capacity = capacity;
    }
    list->ids[list->count++] = id;
    return BATTEN_OK;
}

typedef struct {
    bat_step step;
    const batten_model *model;
    const char *product;
    int placement, context; /* the origin; units and accuracy */
    int definition_shape;   /* of the product, to which representations belong */
    id_list surface_models, curve_sets, styled;
} writing;

static void put_ids(bat_step *step, const int *ids, int count, const char *after)
{
    for (int i = 0; i < count; i++)
        bat_step_id(step, ids[i], i + 1 < count ? "," : after);
}

/* ---- units ---- */

/* A length: a prefix of the metre, or so many of a metre under a name. */
static int put_length(bat_step *step, double metres)
{
    static const struct {
        double metres;
        const char *prefix;
    } prefixes[] = {
        {1, "$"}, {0.001, ".MILLI."}, {0.01, ".CENTI."}, {1000, ".KILO."}, {1e-6, ".MICRO."}};
    for (size_t k = 0; k < sizeof prefixes / sizeof prefixes[0]; k++)
        if (metres == prefixes[k].metres)
            return bat_step_add(step, "", "LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(%s,.METRE.)",
                                prefixes[k].prefix);
    const char *name = batten_unit_name(metres);
    const int metre = bat_step_add(step, "", "LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.)");
    const int exponents = bat_step_add(step, "DIMENSIONAL_EXPONENTS", "1.,0.,0.,0.,0.,0.,0.");
    const int measure = bat_step_open(step, "LENGTH_MEASURE_WITH_UNIT");
    bat_step_token(step, "LENGTH_MEASURE(");
    bat_step_real(step, metres, "),");
    bat_step_id(step, metre, "");
    bat_step_close(step);
    const int id = bat_step_open(step, "");
    bat_step_token(step, "CONVERSION_BASED_UNIT(");
    bat_step_string(step,
                    metres == 0.0254   ? "INCH"
                    : metres == 0.3048 ? "FOOT"
                    : name             ? name
                                       : "UNIT",
                    ",");
    bat_step_id(step, measure, ") ");
    bat_step_token(step, "LENGTH_UNIT() NAMED_UNIT(");
    bat_step_id(step, exponents, ")");
    bat_step_close(step);
    return id;
}

static void put_context(writing *w)
{
    bat_step *step = &w->step;
    const int length = put_length(step, batten_model_unit_metres(w->model));
    const int angle =
        bat_step_add(step, "", "NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.)");
    const int solid =
        bat_step_add(step, "", "NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT()");
    const int accuracy = bat_step_open(step, "UNCERTAINTY_MEASURE_WITH_UNIT");
    bat_step_token(step, "LENGTH_MEASURE(");
    bat_step_real(step, step->tolerance, "),");
    bat_step_id(step, length, ",");
    bat_step_token(step, "'distance_accuracy_value',''");
    bat_step_close(step);
    w->context = bat_step_open(step, "");
    bat_step_token(step,
                   "GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((");
    bat_step_id(step, accuracy, ")) ");
    bat_step_token(step, "GLOBAL_UNIT_ASSIGNED_CONTEXT((");
    bat_step_id(step, length, ",");
    bat_step_id(step, angle, ",");
    bat_step_id(step, solid, ")) ");
    bat_step_token(step, "REPRESENTATION_CONTEXT('','3D')");
    bat_step_close(step);
}

/* ---- the product ---- */

static void put_product(writing *w)
{
    static const double origin[] = {0, 0, 0};
    bat_step *step = &w->step;
    const int application = bat_step_add(
        step, "APPLICATION_CONTEXT", "'core data for automotive mechanical design processes'");
    bat_step_add(step, "APPLICATION_PROTOCOL_DEFINITION",
                 "'international standard','automotive_design',2000,#%d", application);
    const int product_context =
        bat_step_add(step, "PRODUCT_CONTEXT", "'',#%d,'mechanical'", application);
    const int product = bat_step_open(step, "PRODUCT");
    bat_step_string(step, w->product, ",");
    bat_step_string(step, w->product, ",'',(");
    bat_step_id(step, product_context, ")");
    bat_step_close(step);
    bat_step_add(step, "PRODUCT_RELATED_PRODUCT_CATEGORY", "'part',$,(#%d)", product);
    const int formation =
        bat_step_add(step, "PRODUCT_DEFINITION_FORMATION", "'','',#%d", product);
    const int definition_context = bat_step_add(step, "PRODUCT_DEFINITION_CONTEXT",
                                                "'part definition',#%d,'design'", application);
    const int definition = bat_step_add(step, "PRODUCT_DEFINITION", "'design','',#%d,#%d",
                                        formation, definition_context);
    w->definition_shape =
        bat_step_add(step, "PRODUCT_DEFINITION_SHAPE", "'','',#%d", definition);
    const int point = bat_step_point(step, origin);
    const int z = bat_step_add(step, "DIRECTION", "'',(0.,0.,1.)");
    const int x = bat_step_add(step, "DIRECTION", "'',(1.,0.,0.)");
    w->placement = bat_step_add(step, "AXIS2_PLACEMENT_3D", "'',#%d,#%d,#%d", point, z, x);
}

/* ---- colours ---- */

static int put_colour(bat_step *step, const double rgb[3])
{
    const int id = bat_step_open(step, "COLOUR_RGB");
    bat_step_token(step, "'',");
    for (int k = 0; k < 3; k++)
        bat_step_real(step, rgb[k], k < 2 ? "," : "");
    bat_step_close(step);
    return id;
}

static int put_fill(bat_step *step, int colour)
{
    int id = bat_step_add(step, "FILL_AREA_STYLE_COLOUR", "'',#%d", colour);
    id = bat_step_add(step, "FILL_AREA_STYLE", "'',(#%d)", id);
    id = bat_step_add(step, "SURFACE_STYLE_FILL_AREA", "#%d", id);
    id = bat_step_add(step, "SURFACE_SIDE_STYLE", "'',(#%d)", id);
    return bat_step_add(step, "SURFACE_STYLE_USAGE", ".BOTH.,#%d", id);
}

static int put_stroke(bat_step *step, int colour)
{
    const int font = bat_step_add(step, "DRAUGHTING_PRE_DEFINED_CURVE_FONT", "'continuous'");
    return bat_step_add(step, "CURVE_STYLE", "'',#%d,POSITIVE_LENGTH_MEASURE(0.1),#%d", font,
                        colour);
}

static batten_status style(writing *w, const batten_object *object, int item)
{
    bat_step *step = &w->step;
    if (!object->has_colour)
        return BATTEN_OK;
    const int colour = put_colour(step, object->colour);
    const int look = object->kind == BATTEN_OBJECT_SURFACE ? put_fill(step, colour)
                                                           : put_stroke(step, colour);
    const int assignment = bat_step_add(step, "PRESENTATION_STYLE_ASSIGNMENT", "(#%d)", look);
    return add_id(&w->styled,
                  bat_step_add(step, "STYLED_ITEM", "'',(#%d),#%d", assignment, item));
}

/* ---- objects ---- */

static batten_status write_surface(writing *w, const batten_object *object)
{
    bat_step *step = &w->step;
    batten_surface *surface = NULL;
    batten_status status = bat_prepare_surface(object, step->tolerance, step->notes, &surface);
    if (status != BATTEN_OK)
        return status;
    const int face = bat_step_face(step, object->name, surface);
    batten_surface_unref(surface);
    if (!face) {
        batten_notes_add(step->notes, "", 0, object->name,
                         "the border of the surface is one point; left out");
        return BATTEN_OK;
    }
    const int shell = bat_step_open(step, "OPEN_SHELL");
    bat_step_string(step, object->name, ",(");
    bat_step_id(step, face, ")");
    bat_step_close(step);
    const int model = bat_step_open(step, "SHELL_BASED_SURFACE_MODEL");
    bat_step_string(step, object->name, ",(");
    bat_step_id(step, shell, ")");
    bat_step_close(step);
    status = add_id(&w->surface_models, model);
    return status == BATTEN_OK ? style(w, object, face) : status;
}

/* A set of the curves and points `first` .. `first` + count - 1. */
static batten_status put_set(writing *w, const char *name, int first, int count)
{
    bat_step *step = &w->step;
    const int id = bat_step_open(step, "GEOMETRIC_CURVE_SET");
    bat_step_string(step, name, ",(");
    for (int i = 0; i < count; i++)
        bat_step_id(step, first + i, i + 1 < count ? "," : ")");
    bat_step_close(step);
    return add_id(&w->curve_sets, id);
}

static batten_status write_curve(writing *w, const batten_object *object)
{
    bat_step *step = &w->step;
    batten_curve *curve = NULL;
    batten_status status = bat_prepare_curve(object, &curve);
    if (status != BATTEN_OK)
        return status;
    const size_t count = (size_t)batten_curve_point_count(curve);
    const bat_step_row row = {.degree = batten_curve_degree(curve),
                              .count = (int)count,
                              .knots = batten_curve_knots(curve),
                              .points = batten_curve_points(curve),
                              .weights = batten_curve_weights(curve),
                              .stride = 1,
                              .first_id =
                                  bat_step_points(step, batten_curve_points(curve), count)};
    const int id = bat_step_curve(step, object->name, &row);
    batten_curve_unref(curve);
    status = put_set(w, object->name, id, 1);
    return status == BATTEN_OK ? style(w, object, id) : status;
}

static batten_status write_points(writing *w, const batten_object *object)
{
    if (object->point_count == 0)
        return BATTEN_OK;
    const int first = bat_step_points(&w->step, object->points, (size_t)object->point_count);
    return put_set(w, object->name, first, object->point_count);
}

static batten_status write_object(writing *w, const batten_object *object)
{
    if (w->step.count > 1000000000)
        return bat_fail(BATTEN_TOO_LARGE, "a STEP file has room for 1000000000 instances");
    switch (object->kind) {
    case BATTEN_OBJECT_SURFACE:
        return write_surface(w, object);
    case BATTEN_OBJECT_CURVE:
        return write_curve(w, object);
    case BATTEN_OBJECT_POINTS:
        return write_points(w, object);
    default: /* what the format does not hold was taken out before */
        return BATTEN_OK;
    }
}

/* ---- representations ---- */

static int put_representation(writing *w, const char *keyword, const id_list *items)
{
    bat_step *step = &w->step;
    const int id = bat_step_open(step, keyword);
    bat_step_string(step, w->product, ",(");
    bat_step_id(step, w->placement, ",");
    put_ids(step, items->ids, items->count, "),");
    bat_step_id(step, w->context, "");
    bat_step_close(step);
    return id;
}

/* Faces and curves need representations of their own; where there are both, or neither, an
 * empty one holds them together. */
static void put_representations(writing *w)
{
    bat_step *step = &w->step;
    int faces = 0, curves = 0, main;
    if (w->surface_models.count)
        faces =
            put_representation(w, "MANIFOLD_SURFACE_SHAPE_REPRESENTATION", &w->surface_models);
    if (w->curve_sets.count)
        curves = put_representation(w, "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION",
                                    &w->curve_sets);
    main = faces ? faces : curves;
    if (!faces == !curves) {
        main = bat_step_add(step, "SHAPE_REPRESENTATION", "'',(#%d),#%d", w->placement,
                            w->context);
        if (faces) {
            bat_step_add(step, "SHAPE_REPRESENTATION_RELATIONSHIP", "'','',#%d,#%d", main,
                         faces);
            bat_step_add(step, "SHAPE_REPRESENTATION_RELATIONSHIP", "'','',#%d,#%d", main,
                         curves);
        }
    }
    bat_step_add(step, "SHAPE_DEFINITION_REPRESENTATION", "#%d,#%d", w->definition_shape, main);
    if (w->styled.count == 0)
        return;
    bat_step_open(step, "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION");
    bat_step_token(step, "'',(");
    put_ids(step, w->styled.ids, w->styled.count, "),");
    bat_step_id(step, w->context, "");
    bat_step_close(step);
}

/* ---- the file ---- */

static void put_header(bat_step *step, const batten_write_options *options)
{
    batten_text_add(&step->text, "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n");
    step->line = step->text.length;
    bat_step_token(step, "FILE_NAME(");
    bat_step_string(step, options->name, ",");
    bat_step_string(step, options->date ? options->date : "2000-01-01T00:00:00", ",(''),(''),");
    batten_text_add(&step->text, "'Batten %s','Batten','');\n", batten_version());
    batten_text_add(&step->text,
                    "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\n"
                    "ENDSEC;\nDATA;\n");
    step->line = step->text.length;
}

static batten_status write_all(writing *w, const batten_write_options *options)
{
    put_header(&w->step, options);
    put_product(w);
    put_context(w);
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(w->model); i++)
        status = write_object(w, batten_model_object(w->model, i));
    if (status == BATTEN_OK) {
        put_representations(w);
        batten_text_add(&w->step.text, "ENDSEC;\nEND-ISO-10303-21;\n");
    }
    return status;
}

batten_status bat_write_step(const batten_model *model, const batten_write_options *options,
                             batten_notes *notes, batten_text *text)
{
    batten_model *scaled = NULL;
    batten_status status = BATTEN_OK;
    if (batten_model_unit_metres(model) > 0) {
        scaled = batten_model_ref(model);
    } else {
        batten_notes_add(notes, "", 0, "", "the model has no unit; written as mm");
        status = batten_model_to_unit(model, 0.001, &scaled);
    }
    if (status != BATTEN_OK)
        return status;
    const double tolerance =
        options->tolerance > 0 ? options->tolerance : 1e-6 / batten_model_unit_metres(scaled);
    writing w = {.step = {.text = BATTEN_TEXT, .notes = notes, .tolerance = tolerance},
                 .model = scaled,
                 .product = options->name};
    status = write_all(&w, options);
    if (status == BATTEN_OK)
        batten_text_bytes(text, w.step.text.bytes, w.step.text.length);
    text->failed |= w.step.text.failed;
    batten_text_free(&w.step.text);
    bat_release(w.surface_models.ids);
    bat_release(w.curve_sets.ids);
    bat_release(w.styled.ids);
    batten_model_unref(scaled);
    return status;
}
