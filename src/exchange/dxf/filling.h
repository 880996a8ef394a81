/* A model that is filled with the entities of a DXF file. */
#ifndef BAT_DXF_FILLING_H
#define BAT_DXF_FILLING_H
#include "exchange/dxf/blocks.h"
#include "exchange/dxf/dxf.h"
#include "exchange/dxf/entities.h"
#include "exchange/dxf/survey.h"

/* What a model that is being filled needs: the model of the file, or that of a block. */
typedef struct {
    bat_dxf_reading *r;
    bat_dxf_pairs pairs;
    batten_model *model;
    bat_dxf_polyline polyline;
    batten_object polyline_look; /* as its first entity says: those of its parts may be bare */
    bat_dxf_part polyline_part;
    char polyline_layer[BAT_DXF_NAME];
    bat_list faces; /* of double[9]: triangles of 3DFACEs that follow one another */
    batten_object face_look;
    bat_dxf_block *block;         /* that is being built, or NULL */
    bat_dxf_part part, face_part; /* what bat_dxf_read_look found; of the face_look */
    char face_layer[BAT_DXF_NAME], face_name[64];
    int depth;
} bat_dxf_filling;

/* A layer that the file does not describe, or that is plain. */
void bat_dxf_colour_of_layer(const bat_dxf_layer_entry *on, double colour[3]);
/* Layer, colour, and whether it is shown; bad numbers are as if they were not there. What lies
 * on layer 0 of a block has the layer of the INSERT. The plain colour is none, but in blocks,
 * where an object without one takes that of the INSERT, it is black. */
void bat_dxf_read_look(bat_dxf_filling *f, char layer_name[BAT_DXF_NAME],
                       batten_object *object);
batten_status bat_dxf_add_object(bat_dxf_filling *f, const batten_object *object,
                                 const bat_dxf_part *part);
batten_status bat_dxf_leave_out(bat_dxf_filling *f, const char *kind, int line);
batten_status bat_dxf_add_curve(bat_dxf_filling *f, const char *kind, batten_curve *curve);
batten_status bat_dxf_add_point(bat_dxf_filling *f);

/* The triangles so far as one mesh; corners at the same point are one vertex. */
batten_status bat_dxf_flush_faces(bat_dxf_filling *f);
/* Faces that follow one another on one layer, in one colour, are one mesh. */
batten_status bat_dxf_add_face(bat_dxf_filling *f);

#endif
