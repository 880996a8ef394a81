/* glTF 2.0 in one file of bytes, .glb: metres, y up, numbers of 32 bits. It is written.
 * Source: [glTF2]. */
#ifndef BAT_GLTF_H
#define BAT_GLTF_H
#include <batten/exchange.h>
#include <batten/text.h>

/* Instances become nodes that share the meshes of their definition. */
batten_status bat_write_gltf(const batten_model *model, const batten_write_options *options,
                             batten_notes *notes, batten_text *text);

#endif
