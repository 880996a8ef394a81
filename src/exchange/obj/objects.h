/* The objects of an OBJ file while they are made. */
#ifndef BAT_OBJ_OBJECTS_H
#define BAT_OBJ_OBJECTS_H
#include "exchange/obj/obj.h"

/* One mesh, line or row of points while it is made. */
typedef struct {
    bat_obj *obj;
    batten_model *model;
    int *local;                  /* [vertices] index in the mesh, valid where stamp says so */
    size_t *stamp;               /* [vertices] the mesh that it was last used in */
    size_t stamped;              /* meshes so far */
    bat_list used;               /* of int: vertices of the mesh */
    bat_list triangles, normals; /* of int[3]; of double[9] */
    bat_list places, cut;        /* of a polygon; of numbers */
    int odd;
    size_t cut_up; /* faces of more than three corners, in all parts */
    bool has_normals, lacks_normals;
    char *name, *group;
} bat_obj_making;

const bat_obj_vertex *bat_obj_vertex_at(const bat_obj *obj, int64_t index);
/* Elements have no indices below 0. */
bool bat_obj_is_vertex(const bat_obj *obj, int64_t index);
/* Are all corners there? Else a note, and the element is left out. */
bool bat_obj_check_corners(const bat_obj_making *m, const bat_obj_element *element);
/* The group is the name of the object when both are there. */
batten_status bat_obj_name_part(bat_obj_making *m, const bat_obj_part *part,
                                const char *otherwise);
batten_status bat_obj_add_object(bat_obj_making *m, const bat_obj_part *part,
                                 batten_object object, const char *otherwise);

/* All faces of the part as one mesh. */
batten_status bat_obj_make_mesh(bat_obj_making *m, const bat_obj_part *part, size_t end);

#endif
