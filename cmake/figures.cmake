# SPDX-License-Identifier: BSD-3-Clause
# The paper's figures that can be computed, on samples of ours, by one command:
# cmake --build --preset release --target figures. docs/paper.md says which is which.
if(NOT TARGET relievo)
  return()
endif()

set(figures ${CMAKE_BINARY_DIR}/figures)
set(samples ${CMAKE_SOURCE_DIR}/data/samples)
set(strokes ${CMAKE_SOURCE_DIR}/data/strokes)

# Force against time on a flat and on a curved region.
foreach(region IN ITEMS flat curved)
  set(square_flat 240,60,50,50)
  set(square_curved 65,75,50,50)
  list(APPEND force_figures COMMAND relievo touch ${samples}/relief_f.ply --level 0
    --region ${square_${region}} --stroke ${strokes}/${region}.csv
    -o ${figures}/force_${region}.csv --plot ${figures}/force_${region}.svg)
endforeach()

# The same on both regions under all four proxies, side by side.
if(RELIEVO_BUILD_TESTS)
  foreach(region IN ITEMS flat curved)
    foreach(proxy IN ITEMS equation successive facets spline)
      set(how_equation --proxy equation --surface exact)
      set(how_successive --proxy successive --surface exact)
      set(how_facets --surface exact)
      set(how_spline --surface auto)
      set(name_equation "the paper's equation")
      set(name_successive "successive approximation")
      set(name_facets "converged, bilinear")
      set(name_spline "converged, smooth (default)")
      set(log ${figures}/force_${region}_${proxy}.csv)
      list(APPEND force_figures COMMAND relievo touch ${samples}/relief_f.ply --level 0
        --region ${square_${region}} --stroke ${strokes}/${region}.csv ${how_${proxy}} -o ${log})
      list(APPEND panels "${region}:${name_${proxy}}:${log}")
    endforeach()
  endforeach()
  list(APPEND force_figures COMMAND force_panels ${figures}/force_proxies.svg ${panels})
endif()

# One object at three levels of detail, the same place each time, then in stereo.
list(APPEND detail_figures
  COMMAND relievo render ${samples}/panel.ply -o ${figures}/detail_1.png
  COMMAND relievo render ${samples}/panel.ply --region 30,40,130,130 -o ${figures}/detail_2.png
  COMMAND relievo render ${samples}/panel.ply --region 110,80,60,60 -o ${figures}/detail_3.png
  COMMAND relievo render ${samples}/panel.ply --stereo anaglyph -o ${figures}/stereo.png)

# The pictures of docs/user: figures, stereo, and one relief in every relief image.
set(panel ${samples}/panel.ply)
list(APPEND user_figures
  COMMAND relievo figure ${panel} --region 110,80,60,60 --width-mm 160 --dpi 150
    -o ${figures}/figure_reference.png --caption ${figures}/figure_reference.txt
  COMMAND relievo figure ${panel} --region 110,80,60,60 --layout detail --width-mm 85 --dpi 150
    --stereo grey --without legend -o ${figures}/figure_anaglyph.png
  COMMAND relievo figure ${panel} --region 110,80,60,60 --layout levels --width-mm 160 --dpi 150
    -o ${figures}/figure_levels.png
  COMMAND relievo figure ${samples}/relief_f.ply --level 0 --region 65,75,50,50 --layout plot
    --recording ${figures}/force_curved.csv --width-mm 160 --dpi 150 -o ${figures}/figure_plot.png)
foreach(relief IN ITEMS lit height hillshade multi slope local skyview openness)
  list(APPEND user_figures COMMAND relievo figure ${panel} --region 110,80,60,60 --layout detail
    --relief ${relief} --without scalebar,heightbar,up,legend --width-mm 42 --dpi 150 --text-pt 6
    -o ${figures}/relief_${relief}.png)
endforeach()

add_custom_target(figures
  COMMAND ${CMAKE_COMMAND} -E make_directory ${figures}
  ${force_figures} ${detail_figures} ${user_figures}
  DEPENDS samples
  COMMENT "Drawing the paper's figures into ${figures}"
  VERBATIM)
