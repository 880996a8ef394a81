/* Notes about the parts of an object, as notes about the object. */
#ifndef BAT_OBJECT_NOTES_H
#define BAT_OBJECT_NOTES_H
#include "base/base.h"
#include <batten/model.h>

/* Hand notes of faces on, "face 5" as "bolt: face 5". Of those that differ in their numbers
 * alone the one whose last number is the largest stands for all, which are counted. A length at
 * the end has its unit. Cost: linear. @param unit_metres  0 for none */
void bat_object_notes(const batten_notes *from, const char *object, double unit_metres,
                      batten_notes *to);

#endif
