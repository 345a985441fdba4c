# SPDX-License-Identifier: BSD-3-Clause
# The paper's figure set (figs. 6 to 8) on one scan:
# cmake -DRELIEVO= -DSCAN= -DVIEW= -DMIDDLE=X,Y -DOUT= -P Sheet.cmake
# writes into OUT the reference with its window at three levels, window_1.png to window_3.png; the holes
# as measured and filled, holes.png; an anaglyph, anaglyph.png; and a press at the middle, moved across
# it, force.svg. MIDDLE is the place that is looked at more and more closely, in thousandths of the map.

function(relievo)
  execute_process(COMMAND ${RELIEVO} ${ARGN} OUTPUT_VARIABLE report COMMAND_ERROR_IS_FATAL ANY)
  set(report "${report}" PARENT_SCOPE)
endfunction()

# The number at a place of a report, in thousandths: CMake counts in whole numbers.
function(thousandths_of result report)
  string(JSON number GET "${report}" ${ARGN})
  if(number MATCHES "e-")  # Less than one of them.
    set(number 0)
  endif()
  string(REGEX MATCH "^(-?)([0-9]+)\\.?([0-9]*)$" found "${number}")
  if(NOT found)
    message(FATAL_ERROR "${number} is no number of a report")
  endif()
  set(sign "${CMAKE_MATCH_1}")
  set(whole ${CMAKE_MATCH_2})
  string(SUBSTRING "${CMAKE_MATCH_3}000" 0 3 rest)
  math(EXPR value "${sign}(${whole} * 1000 + 1${rest} - 1000)")
  set(${result} ${value} PARENT_SCOPE)
endfunction()

# Thousandths as millimetres, "-0.250".
function(millimetres result expression)
  math(EXPR value "${expression}")
  set(sign "")
  if(value LESS 0)
    set(sign "-")
    math(EXPR value "-(${value})")
  endif()
  math(EXPR whole "${value} / 1000")
  math(EXPR rest "${value} % 1000 + 1000")
  string(SUBSTRING ${rest} 1 3 rest)
  set(${result} "${sign}${whole}.${rest}" PARENT_SCOPE)
endfunction()

set(scan ${SCAN} --view ${VIEW} --unit mm --cells 800)
set(map ${OUT}/map.tif)
file(MAKE_DIRECTORY ${OUT})
relievo(depthmap ${scan} -o ${map})

relievo(render ${map} --pixels 16 -o ${OUT}/size.png --report json)
thousandths_of(x "${report}" region_mm 0)
thousandths_of(y "${report}" region_mm 1)
thousandths_of(side "${report}" region_mm 2)
string(REPLACE "," ";" middle "${MIDDLE}")
list(GET middle 0 middle_x)
list(GET middle 1 middle_y)
set(share_1 1000)
set(share_2 500)
set(share_3 250)
foreach(window IN ITEMS 1 2 3)
  set(part "${side} * ${share_${window}} / 1000")
  millimetres(width "${part}")
  if(window EQUAL 1)
    set(region)
  else()
    millimetres(left "${x} + ${side} * ${middle_x} / 1000 - ${part} / 2")
    millimetres(low "${y} + ${side} * ${middle_y} / 1000 - ${part} / 2")
    set(region --region ${left},${low},${width},${width})
  endif()
  relievo(figure ${map} ${region} --width-mm 160 --dpi 110 -o ${OUT}/window_${window}.png)
endforeach()
relievo(figure ${scan} --holes interpolate:1000000 --layout beforeafter --width-mm 160 --dpi 110
  -o ${OUT}/holes.png)
relievo(figure ${map} --layout detail --stereo dubois --width-mm 80 --dpi 220 -o ${OUT}/anaglyph.png)

# The press starts above the surface by 4 % of the side and goes in by 2 %.
millimetres(x0 "${x} + ${side} * 45 / 100")
millimetres(x1 "${x} + ${side} * 55 / 100")
millimetres(ym "${y} + ${side} / 2")
relievo(measure ${map} --point ${x0},${ym} --point ${x1},${ym} --report json)
thousandths_of(z0 "${report}" measurements 0 quantities 0 value)
thousandths_of(z1 "${report}" measurements 1 quantities 0 value)
millimetres(up "${z0} + ${side} * 4 / 100")
millimetres(in0 "${z0} - ${side} * 2 / 100")
millimetres(in1 "${z1} - ${side} * 2 / 100")
file(WRITE ${OUT}/stroke.csv "t_s,x_mm,y_mm,z_mm\n0,${x0},${ym},${up}\n1,${x0},${ym},${in0}\n"
  "3,${x1},${ym},${in1}\n4,${x1},${ym},${in1}\n")
relievo(touch ${map} --stroke ${OUT}/stroke.csv -o ${OUT}/force.csv --plot ${OUT}/force.svg)
