#ifndef BATTEN_MODEL_H
#define BATTEN_MODEL_H
/**
 * @file
 * Named objects with a unit: what files are read into and written from, and what flows between
 * the features of a design.
 */
#include <batten/chain.h>
#include <batten/mesh.h>
#include <batten/hull.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_object_kind {
    BATTEN_OBJECT_POINTS, /**< a row of points, in order */
    BATTEN_OBJECT_CURVE,
    BATTEN_OBJECT_SURFACE,
    BATTEN_OBJECT_OFFSET_TABLE, /**< a table of offsets */
    BATTEN_OBJECT_TRIANGLES,    /**< Bezier triangles, in space */
    BATTEN_OBJECT_BODY,         /**< trimmed faces, shells, a solid */
    BATTEN_OBJECT_MESH,
    BATTEN_OBJECT_INSTANCE /**< another model, placed */
} batten_object_kind;
/**
 * "row of points", "curve", "surface", "table of offsets", "set of Bezier triangles", "body",
 * "mesh", "instance".
 *
 * @param kind  of an object
 */
BATTEN_API const char *batten_object_kind_name(batten_object_kind kind);

typedef struct batten_model batten_model;

/** One object of a model; what its kind does not use is NULL or 0. */
typedef struct batten_object {
    const char *name;
    const char *layer; /**< "" for none */
    const char *group; /**< "" for none; of a group within a group "outer/inner" */
    bool is_hidden;    /**< the file says that it is not to be shown */
    bool has_colour;
    double colour[3]; /**< sRGB, 0..1 */
    batten_object_kind kind;
    const batten_curve *curve;
    const batten_chain
        *chain; /**< of a CURVE: what it truly is, when not NURBS; `curve` is then
                                    near to it */
    const batten_surface *surface;
    const batten_offset_table *offset_table;
    const batten_triangles *triangles;
    const batten_body *body;
    const batten_mesh *mesh;
    const batten_model *definition; /**< of an INSTANCE; in the unit of the model */
    batten_affine place;            /**< of an INSTANCE: from the definition into the model */
    int point_count;          /**< POINTS; also of a CURVE: the data that it was made from */
    const double *points;     /**< [point_count][3] */
    const double *parameters; /**< [point_count], of the data on the curve; or NULL */
    bool
        points_are_vertices; /**< of a CURVE: of the polygon that shapes it, which it may leave */
} batten_object;

/* A model is filled by its maker, then shared as const. */

/**
 * An empty model.
 *
 * @param unit_metres  how many metres one unit is; 0 when nothing says so
 * @param[out] out  give the reference back with batten_model_unref
 * @return BATTEN_OK, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_model_create(double unit_metres, batten_model **out);
/** One more reference to a model, from borrowed to yours. */
BATTEN_API batten_model *batten_model_ref(const batten_model *model);
/** Give a reference to a model back; NULL is welcome. */
BATTEN_API void batten_model_unref(batten_model *model);
/** What the model is called, as the product of a file or the definition of an instance; "" for
 * none. Copies of a model in another form have the name too. The name lives as long as the
 * model has it. */
BATTEN_API const char *batten_model_name(const batten_model *model);
/**
 * Name a model.
 *
 * @param model  any model that nobody else holds
 * @param name  copied; NULL and "" for none
 * @return BATTEN_OK, OUT_OF_MEMORY
 *
 * Cost: linear in the name.
 */
BATTEN_API batten_status batten_model_set_name(batten_model *model, const char *name);
/** How many metres one unit of the model is. */
BATTEN_API double batten_model_unit_metres(const batten_model *model);
/** How many objects the model has at its top. */
BATTEN_API int batten_model_count(const batten_model *model);
/**
 * The object of this index, 0 .. batten_model_count() - 1; borrowed.
 *
 * @param model  any model
 */
BATTEN_API const batten_object *batten_model_object(const batten_model *model, int index);
/**
 * The index of the first object of that name, or -1.
 *
 * @param model  any model
 */
BATTEN_API int batten_model_find(const batten_model *model, const char *name);
/**
 * Copy an object in: names and arrays are copied, geometry is referenced.
 *
 * @param model  any model that nobody else holds
 * @param object  see the struct
 * @return BATTEN_OK; BAD_ARGUMENT, NOT_FINITE; TOO_LARGE for instances within instances more
 * than 32 deep; OUT_OF_MEMORY
 *
 * Cost: linear in the names and points that are copied.
 */
BATTEN_API batten_status batten_model_add(batten_model *model, const batten_object *object);
/**
 * Add the object as an affine map takes it. A plane curve that leaves its plane becomes one in
 * space; a chain that is not kept in shape goes, its curve stays. Under a map that mirrors the
 * outside of bodies, meshes, surfaces and triangles stays outside: u of a surface then runs the
 * other way.
 *
 * @param model  any model that nobody else holds
 * @param object  see the struct
 * @param map  finite and not singular
 * @return as batten_model_add; BAD_ARGUMENT for a singular map; UNSUPPORTED for a table of
 * offsets
 *
 * Cost: linear in the geometry of the object.
 */
BATTEN_API batten_status batten_model_add_mapped(batten_model *model,
                                                 const batten_object *object,
                                                 const batten_affine *map);
/**
 * The same model with instances replaced by what they place, named "instance/object"; the
 * model itself when it has none. Objects without a layer or a colour have that of the instance,
 * and are hidden when an instance around them is.
 *
 * @param model  looked at only
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; TOO_LARGE, before the work, for more objects (instances among them) than
 * 100,000 and 40 times those of the model and its definitions, or than a million; for more
 * points than 10 million and 40 times theirs; BAD_ARGUMENT, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the geometry of the result.
 */
BATTEN_API batten_status batten_model_flat(const batten_model *model, batten_model **out);
/**
 * The objects of the model and of each definition once, where they are defined, named
 * "definition/object"; without the instances. Cost: linear.
 *
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY
 */
BATTEN_API batten_status batten_model_once(const batten_model *model, batten_model **out);
/**
 * How deep instances lie within instances: 0 without any.
 *
 * @param model  any model
 */
BATTEN_API int batten_model_depth(const batten_model *model);
/**
 * The box of all objects; false when there is none.
 *
 * @param model  any model
 */
BATTEN_API bool batten_model_box(const batten_model *model, batten_box *box);
/**
 * The same model in another unit; geometry is scaled. A model without a unit is taken to be in
 * that unit already.
 *
 * @param model  looked at only
 * @param unit_metres  metres of one unit, above 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the geometry.
 */
BATTEN_API batten_status batten_model_to_unit(const batten_model *model, double unit_metres,
                                              batten_model **out);

/** How triangles become tensor patches. */
typedef enum batten_patches {
    BATTEN_PATCHES_REGULAR, /**< three to a triangle, without poles: for files */
    BATTEN_PATCHES_POLE /**< one to a triangle, whose sides and pole are edges and corner of the
                             triangle: for pictures */
} batten_patches;
/**
 * The same model with its Bezier triangles as exact NURBS patches, named "NAME.1", "NAME.2"
 * ...; the model itself when it has none.
 *
 * @param model  looked at only
 * @param patches  how each triangle becomes patches
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; TOO_LARGE for more than a million patches; OUT_OF_MEMORY
 *
 * Cost: linear in the triangles.
 */
BATTEN_API batten_status batten_model_with_patches(const batten_model *model,
                                                   batten_patches patches, batten_model **out);
/**
 * The same model with its surfaces, Bezier triangles and bodies as meshes, one for each object,
 * under the same name, layer, group and colour. Definitions of instances are meshed once, by
 * what they measure where they are defined. Points, curves, tables and meshes stay.
 * @param model  looked at only
 * @param options NULL for the defaults; `most` is for all objects together
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param notes faces that were left out, and chords that are not met, each with its object; may
 * be NULL
 * @param[out] out  the model; as it was when the function fails
 * @return BATTEN_OK, as batten_mesh_from_body, also when faces were left out
 *
 * Cost: that of batten_mesh_from_body for each object.
 */
BATTEN_API batten_status batten_model_meshed(const batten_model *model,
                                             const batten_mesh_options *options,
                                             const batten_job *job, batten_notes *notes,
                                             batten_model **out);

#ifdef __cplusplus
}
#endif
#endif
