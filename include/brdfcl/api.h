/*
 * api.h - what a public function of libbrdfcl carries, so that it is seen outside the library.
 */
#ifndef BRDFCL_API_H
#define BRDFCL_API_H

#ifndef BRDFCL_API
#ifdef __GNUC__
#define BRDFCL_API __attribute__((visibility("default")))
#else
#define BRDFCL_API
#endif
#endif

#endif
