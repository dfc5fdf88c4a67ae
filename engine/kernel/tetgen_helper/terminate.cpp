// TetGen 1.5.0's own terminatetetgen frees the mesh and throws, the mesh's destructor then frees it
// again and the process dies with a bad pointer instead of telling what was wrong. The library
// calls it through the dynamic linker, which finds this one first.
class tetgenmesh;
void terminatetetgen(tetgenmesh*, int exit_code);
void terminatetetgen(tetgenmesh*, int exit_code) { throw exit_code; }
