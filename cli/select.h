/* One object of a model, by the name behind the hash of file#name. */
#ifndef SELECT_H
#define SELECT_H
#include <batten/model.h>

/* Keep only the object of that name, else of that path: what instances place is an object too,
 * where it stands, and so are instances within instances. NOT_FOUND with the nearest names. */
batten_status select_object(const char *name, batten_model **model);

#endif
