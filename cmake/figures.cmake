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
foreach(relief IN ITEMS lit height hillshade multi slope local skyview openness multiscale curvature occlusion)
  list(APPEND user_figures COMMAND relievo figure ${panel} --region 110,80,60,60 --layout detail
    --relief ${relief} --without scalebar,heightbar,up,legend --width-mm 42 --dpi 150 --text-pt 6
    -o ${figures}/relief_${relief}.png)
endforeach()
foreach(colours IN ITEMS cividis batlow grey)
  list(APPEND user_figures COMMAND relievo figure ${panel} --region 110,80,60,60 --layout detail
    --relief height --colours ${colours} --without scalebar,heightbar,up,legend --width-mm 42
    --dpi 150 --text-pt 6 -o ${figures}/relief_${colours}.png)
endforeach()

# The holes case: what was not measured, as measured and filled.
list(APPEND user_figures
  COMMAND relievo figure ${samples}/relief_f.ply --unit mm --view top --holes interpolate:1000
    --layout beforeafter --region 130,40,45,45 --width-mm 120 --dpi 150
    -o ${figures}/figure_holes.png)

add_custom_target(figures
  COMMAND ${CMAKE_COMMAND} -E make_directory ${figures}
  ${force_figures} ${detail_figures} ${user_figures}
  DEPENDS samples
  COMMENT "Drawing the paper's figures into ${figures}"
  VERBATIM)

# Every picture of docs/user again: figures by the command line, the window by a program that works
# in it. cmake --build --preset release --target user-pictures; needs a display, or Xvfb.
if(TARGET user_pictures)
  set(user ${CMAKE_SOURCE_DIR}/docs/user)
  file(GLOB kept RELATIVE ${user} CONFIGURE_DEPENDS ${user}/figure_*.png ${user}/relief_*.png)
  foreach(picture IN LISTS kept)
    list(APPEND kept_figures ${figures}/${picture})
  endforeach()
  add_custom_target(user-pictures
    COMMAND ${CMAKE_COMMAND} -E copy ${kept_figures} ${user}
    COMMAND ${CMAKE_COMMAND} -E copy ${figures}/force_flat.svg ${figures}/force_curved.svg
      ${figures}/force_proxies.svg ${user}/paper
    COMMAND user_pictures ${user}
    COMMAND user_pictures ${user} de
    COMMAND user_pictures ${user} hi
    COMMENT "Making the pictures of docs/user anew"
    VERBATIM)
  add_dependencies(user-pictures figures)
endif()

# The paper's figure set on one relief: reference and window at three levels, holes, anaglyph, forces.
# On our own panel; and, where the folder of shared scans is there, on three scans whose licence
# allows pictures with credit. The sheets are kept in docs/user/paper.
if(TARGET contact_sheet)
  set(sheets ${CMAKE_BINARY_DIR}/sheets)
  if(DEFINED ENV{RELIEVO_SHARED_DATA})
    set(shared $ENV{RELIEVO_SHARED_DATA})
  else()
    set(shared ${CMAKE_SOURCE_DIR}/../shared/data)
  endif()
  # Name, scan, side of view, place to look at closely (Sheet.cmake), credit.
  function(relievo_sheet name scan view middle credit)
    set(out ${sheets}/${name})
    set(commands COMMAND ${CMAKE_COMMAND} -DRELIEVO=$<TARGET_FILE:relievo> -DSCAN=${scan}
      -DVIEW=${view} -DMIDDLE=${middle} -DOUT=${out} -P ${CMAKE_SOURCE_DIR}/cmake/Sheet.cmake)
    set(entries "${credit}=" "The whole object: reference and window=${out}/window_1.png"
      "A finer level=${out}/window_2.png" "The finest level=${out}/window_3.png"
      "As measured, and filled=${out}/holes.png" "Anaglyph (Dubois)=${out}/anaglyph.png"
      "z and force against time=${out}/force.svg")
    set(sheet_commands ${sheet_commands} ${commands} PARENT_SCOPE)
    set(sheet_entries ${sheet_entries} ${entries} PARENT_SCOPE)
  endfunction()
  relievo_sheet(panel ${samples}/panel.ply top 500,500
    "Carved panel. Sample of this project, BSD-3-Clause")
  set(changed "Its file says no unit: shown as mm. Made into a height field and rendered by relievo")
  if(EXISTS ${shared}/obj/demosthenes-low-res.obj)
    relievo_sheet(demosthenes ${shared}/obj/demosthenes-low-res.obj auto 500,650
      "Bust of Demosthenes, Louvre. Scan by ryanfb, CC BY 4.0 (odedstein/meshes). ${changed}")
    relievo_sheet(dancing_girl ${shared}/ply/DancingGirl_be.ply auto 500,700
      "Dancing Girl by B. Thorvaldsen, Thorvaldsens Museum. Scan by Geoffrey Marchal, CC BY 4.0 (keijiro/DanishStatues). ${changed}")
    relievo_sheet(mountain ${shared}/obj/mountain.obj auto 550,450
      "Mountain. Scan by lastloginname, CC BY 4.0 (odedstein/meshes). ${changed}")
  endif()
  add_custom_target(sheets
    ${sheet_commands}
    COMMAND contact_sheet ${sheets}/contact_sheet.png 3 420 ${sheet_entries}
    DEPENDS samples contact_sheet relievo
    COMMENT "Drawing the paper's figure set into ${sheets}"
    VERBATIM)
endif()
