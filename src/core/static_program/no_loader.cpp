// SPDX-License-Identifier: MIT
// In a static program (`make STATIC=1`) nothing can be loaded at run time. GLPK would load database drivers
// for its modelling language, which Pantin does not use; these take the place of libltdl's functions and say
// that there are none.
extern "C" {
int lt_dlinit() { return 1; }
int lt_dlexit() { return 0; }
void* lt_dlopen(const char*) { return nullptr; }
void* lt_dlsym(void*, const char*) { return nullptr; }
int lt_dlclose(void*) { return 1; }
const char* lt_dlerror() { return "this program is static"; }
}
