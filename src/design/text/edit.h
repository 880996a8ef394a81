/* Changing one value of a text, and nothing else. */
#ifndef BAT_DESIGN_EDIT_H
#define BAT_DESIGN_EDIT_H
#include "design/text/yaml.h"

/*
 * The text with another value at `path` ("features.hull.degree"), or with a new key at the end
 * of its map.
 *
 * A value that needs quotes where it stands gets them. The new text is parsed, and everything
 * but that value must be as before.
 *
 * @param tree  of the text
 * @param[out] out, out_length  the new text, with a zero byte after its end; release it
 */
batten_status bat_edit(const char *text, size_t length, const bat_tree *tree, int nesting,
                       const char *path, const char *value, char **out, size_t *out_length);

#endif
