/* What each entity of a STEP file refers to, as its EXPRESS schema has it. */
#ifndef TESTS_EXCHANGE_STEP_REFERENCES_H
#define TESTS_EXCHANGE_STEP_REFERENCES_H
#include "exchange/step/reading.h"

/* What stands behind "#id=", or NULL. */
static inline const char *step_instance(const char *text, int id)
{
    char head[20];
    snprintf(head, sizeof head, "\n#%d=", id);
    const char *at = strstr(text, head);
    return at ? at + strlen(head) : NULL;
}

/* Is this keyword among those of the instance? */
static inline bool step_is(const char *instance, const char *keyword, size_t length)
{
    const char *end = instance ? strstr(instance, ");\n") : NULL;
    for (const char *at = instance; end && at < end; at++)
        if (strncmp(at, keyword, length) == 0 && at[length] == '(' &&
            (at == instance || strchr(" (\n", at[-1])))
            return true;
    return false;
}

/* The ids that an instance refers to, in their order; at most so many. */
static inline int step_ids(const char *instance, int most, int *ids)
{
    const char *end = strstr(instance, ");\n");
    bool quoted = false;
    int count = 0;
    for (const char *at = instance; at < end && count < most; at++) {
        quoted ^= *at == '\'';
        if (*at == '#' && !quoted)
            ids[count++] = atoi(at + 1);
    }
    return count;
}

/* Are the references of this instance to entities of these keywords? One may be of several, as "A|B"; the last
 * repeats where a star is behind it. */
static inline void step_check_instance(const char *text, const char *instance,
                                       const char *kinds)
{
    enum { MOST = 200 };
    int ids[MOST];
    const int count = step_ids(instance, MOST, ids);
    for (int i = 0; i < count; i++) {
        const size_t length = strcspn(kinds, " ");
        bool fits = false;
        for (const char *at = kinds; at < kinds + length; at += strcspn(at, "| *") + 1)
            fits |= step_is(step_instance(text, ids[i]), at, strcspn(at, "| *"));
        if (!fits)
            fprintf(stderr, "    reference %d should be to %s: %.80s\n", i + 1, kinds,
                    instance);
        CHECK(fits);
        if (length > 0 && kinds[length - 1] != '*')
            kinds += length + (kinds[length] == ' ');
    }
    CHECK(*kinds == 0 || strchr(kinds, '*')); /* none is missing */
}

#define STEP_CURVES "B_SPLINE_CURVE_WITH_KNOTS"
#define STEP_SHAPES                                                                               \
    "SHAPE_REPRESENTATION|ADVANCED_BREP_SHAPE_REPRESENTATION|"                                    \
    "MANIFOLD_SURFACE_SHAPE_REPRESENTATION|GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION|" \
    "TESSELLATED_SHAPE_REPRESENTATION"

/* Each instance refers to what its entity is made of; [ISO 10303-42], [ISO 10303-41]. */
static inline void step_check_references(const char *text)
{
    static const char *const rows[][2] = {
        {"B_SPLINE_CURVE_WITH_KNOTS", "CARTESIAN_POINT*"},
        {"B_SPLINE_SURFACE_WITH_KNOTS", "CARTESIAN_POINT*"},
        {"VERTEX_POINT", "CARTESIAN_POINT"},
        {"AXIS2_PLACEMENT_3D", "CARTESIAN_POINT DIRECTION DIRECTION"},
        {"DEFINITIONAL_REPRESENTATION", STEP_CURVES " PARAMETRIC_REPRESENTATION_CONTEXT"},
        {"PCURVE", "B_SPLINE_SURFACE_WITH_KNOTS DEFINITIONAL_REPRESENTATION"},
        {"SURFACE_CURVE", STEP_CURVES " PCURVE*"},
        {"SEAM_CURVE", STEP_CURVES " PCURVE PCURVE"},
        {"EDGE_CURVE", "VERTEX_POINT VERTEX_POINT SURFACE_CURVE|SEAM_CURVE|" STEP_CURVES},
        {"ORIENTED_EDGE", "EDGE_CURVE"},
        {"EDGE_LOOP", "ORIENTED_EDGE*"},
        {"VERTEX_LOOP", "VERTEX_POINT"},
        {"FACE_OUTER_BOUND", "EDGE_LOOP|VERTEX_LOOP"},
        {"FACE_BOUND", "EDGE_LOOP|VERTEX_LOOP"},
        {"OPEN_SHELL", "ADVANCED_FACE*"},
        {"CLOSED_SHELL", "ADVANCED_FACE*"},
        {"ORIENTED_CLOSED_SHELL", "CLOSED_SHELL"},
        {"MANIFOLD_SOLID_BREP", "CLOSED_SHELL"},
        {"BREP_WITH_VOIDS", "CLOSED_SHELL ORIENTED_CLOSED_SHELL*"},
        {"SHELL_BASED_SURFACE_MODEL", "OPEN_SHELL|CLOSED_SHELL*"},
        {"ADVANCED_BREP_SHAPE_REPRESENTATION",
         "AXIS2_PLACEMENT_3D MANIFOLD_SOLID_BREP|BREP_WITH_VOIDS|GEOMETRIC_REPRESENTATION_CONTEXT*"},
        {"MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
         "AXIS2_PLACEMENT_3D SHELL_BASED_SURFACE_MODEL|GEOMETRIC_REPRESENTATION_CONTEXT*"},
        {"GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION",
         "AXIS2_PLACEMENT_3D GEOMETRIC_CURVE_SET|GEOMETRIC_REPRESENTATION_CONTEXT*"},
        {"SHAPE_REPRESENTATION",
         "AXIS2_PLACEMENT_3D AXIS2_PLACEMENT_3D|GEOMETRIC_REPRESENTATION_CONTEXT*"},
        {"SHAPE_REPRESENTATION_RELATIONSHIP", STEP_SHAPES " " STEP_SHAPES},
        {"PRODUCT", "PRODUCT_CONTEXT|MECHANICAL_CONTEXT"},
        {"PRODUCT_CONTEXT", "APPLICATION_CONTEXT"},
        {"MECHANICAL_CONTEXT", "APPLICATION_CONTEXT"},
        {"PRODUCT_DEFINITION_CONTEXT", "APPLICATION_CONTEXT"},
        {"DESIGN_CONTEXT", "APPLICATION_CONTEXT"},
        {"APPLICATION_PROTOCOL_DEFINITION", "APPLICATION_CONTEXT"},
        {"PRODUCT_DEFINITION_FORMATION", "PRODUCT"},
        {"PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE", "PRODUCT"},
        {"PRODUCT_DEFINITION",
         "PRODUCT_DEFINITION_FORMATION|PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE "
         "PRODUCT_DEFINITION_CONTEXT|DESIGN_CONTEXT"},
        {"PRODUCT_DEFINITION_SHAPE", "PRODUCT_DEFINITION|NEXT_ASSEMBLY_USAGE_OCCURRENCE"},
        {"SHAPE_DEFINITION_REPRESENTATION", "PRODUCT_DEFINITION_SHAPE " STEP_SHAPES},
        {"NEXT_ASSEMBLY_USAGE_OCCURRENCE", "PRODUCT_DEFINITION PRODUCT_DEFINITION"},
        {"ITEM_DEFINED_TRANSFORMATION", "AXIS2_PLACEMENT_3D AXIS2_PLACEMENT_3D"},
        {"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION",
         STEP_SHAPES " " STEP_SHAPES " ITEM_DEFINED_TRANSFORMATION"},
        {"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION",
         "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION PRODUCT_DEFINITION_SHAPE"},
        {"LENGTH_MEASURE_WITH_UNIT", "LENGTH_UNIT"},
        {"CONVERSION_BASED_UNIT", "LENGTH_MEASURE_WITH_UNIT DIMENSIONAL_EXPONENTS"},
        {"UNCERTAINTY_MEASURE_WITH_UNIT", "LENGTH_UNIT"},
        {"GLOBAL_UNIT_ASSIGNED_CONTEXT",
         "UNCERTAINTY_MEASURE_WITH_UNIT LENGTH_UNIT PLANE_ANGLE_UNIT SOLID_ANGLE_UNIT"},
        {"PRODUCT_RELATED_PRODUCT_CATEGORY", "PRODUCT*"},
        {"PRODUCT_CATEGORY_RELATIONSHIP", "PRODUCT_CATEGORY PRODUCT_RELATED_PRODUCT_CATEGORY"},
        {"PERSON_AND_ORGANIZATION", "PERSON ORGANIZATION"},
        {"LOCAL_TIME", "COORDINATED_UNIVERSAL_TIME_OFFSET"},
        {"DATE_AND_TIME", "CALENDAR_DATE LOCAL_TIME"},
        {"SECURITY_CLASSIFICATION", "SECURITY_CLASSIFICATION_LEVEL"},
        {"CC_DESIGN_SECURITY_CLASSIFICATION",
         "SECURITY_CLASSIFICATION PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE*"},
        {"CC_DESIGN_PERSON_AND_ORGANIZATION_ASSIGNMENT",
         "PERSON_AND_ORGANIZATION PERSON_AND_ORGANIZATION_ROLE "
         "PRODUCT|PRODUCT_DEFINITION|PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE|"
         "SECURITY_CLASSIFICATION*"},
        {"CC_DESIGN_DATE_AND_TIME_ASSIGNMENT",
         "DATE_AND_TIME DATE_TIME_ROLE PRODUCT_DEFINITION|SECURITY_CLASSIFICATION*"},
        {"APPROVAL", "APPROVAL_STATUS"},
        {"APPROVAL_PERSON_ORGANIZATION", "PERSON_AND_ORGANIZATION APPROVAL APPROVAL_ROLE"},
        {"APPROVAL_DATE_TIME", "DATE_AND_TIME APPROVAL"},
        {"CC_DESIGN_APPROVAL",
         "APPROVAL PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE|PRODUCT_DEFINITION|"
         "SECURITY_CLASSIFICATION*"},
        {"FILL_AREA_STYLE_COLOUR", "COLOUR_RGB"},
        {"FILL_AREA_STYLE", "FILL_AREA_STYLE_COLOUR"},
        {"SURFACE_STYLE_FILL_AREA", "FILL_AREA_STYLE"},
        {"SURFACE_SIDE_STYLE", "SURFACE_STYLE_FILL_AREA"},
        {"SURFACE_STYLE_USAGE", "SURFACE_SIDE_STYLE"},
        {"CURVE_STYLE", "DRAUGHTING_PRE_DEFINED_CURVE_FONT COLOUR_RGB"},
        {"POINT_STYLE", "COLOUR_RGB"},
        {"MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION",
         "STYLED_ITEM|GEOMETRIC_REPRESENTATION_CONTEXT*"},
        {"INVISIBILITY", "STYLED_ITEM*"},
        {"GROUP_RELATIONSHIP", "GROUP GROUP"},
        {"TRIANGULATED_FACE", "COORDINATES_LIST"},
        {"TESSELLATED_SHELL", "TRIANGULATED_FACE"},
    };
    const char *instance;
    for (int id = 1; (instance = step_instance(text, id)); id++)
        for (int i = 0; i < COUNT(rows); i++) {
            const size_t length = strlen(rows[i][0]);
            const bool is_complex = *instance == '(';
            if (is_complex && strcmp(rows[i][0], "SHAPE_REPRESENTATION_RELATIONSHIP") == 0)
                continue; /* there it is without references: another part has them */
            if (is_complex
                    ? step_is(instance, rows[i][0], length)
                    : strncmp(instance, rows[i][0], length) == 0 && instance[length] == '(')
                step_check_instance(text, instance, rows[i][1]);
        }
}

#endif
