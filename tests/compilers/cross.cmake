# SPDX-License-Identifier: LGPL-2.1-or-later
# What the toolchains for other systems share. The preset adds the compiler.
# This machine's /usr/include must not come before the other system's headers, so only the
# header-only libraries are visible, through links.
set(headers ${CMAKE_CURRENT_LIST_DIR}/../../build/compilers/include)
file(MAKE_DIRECTORY ${headers})
foreach(library CGAL boost hwy)
  if(NOT EXISTS ${headers}/${library})
    file(CREATE_LINK /usr/include/${library} ${headers}/${library} SYMBOLIC)
  endif()
endforeach()
set(CGAL_INCLUDE ${headers})
set(BOOST_INCLUDE ${headers})
set(HWY_INCLUDE ${headers})
set(Eigen3_DIR /usr/share/eigen3/cmake)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
