/* Words that go with a count of any type: "1 point is", "2 points are". */
#ifndef BAT_PLURAL_H
#define BAT_PLURAL_H

/* The ending of a regular noun. */
#define bat_plural(count) ((count) == 1 ? "" : "s")
/* "vertex" or "vertices", "is" or "are". */
#define bat_one_or_many(count, one, many) ((count) == 1 ? (one) : (many))

#endif
