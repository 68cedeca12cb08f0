#pragma once
/// What becomes of a lack of memory that nothing can catch: in the initialisers of libraries, which run before main()
/// (the exact distances' library sets up trees of its own), in destructors, and where there is no memory for an
/// exception. It would end the program by std::terminate(); it ends it with a message and the exit status for it.

namespace spectralpack::cli {

/// To be called first by main(): until then, all that ends the program this way is taken for a lack of memory.
void begin_main();

}  // namespace spectralpack::cli
