# SPDX-License-Identifier: BSD-3-Clause
# A press at the middle of a map, moved across it, as in the paper's force figure:
# cmake -DRELIEVO= -DMAP= -DOUT= -P SheetStroke.cmake writes OUT/force.svg and force.csv.
execute_process(COMMAND ${RELIEVO} render ${MAP} --pixels 16 -o ${OUT}/size.png --report json
  OUTPUT_VARIABLE report COMMAND_ERROR_IS_FATAL ANY)
string(JSON x GET "${report}" region_mm 0)
string(JSON y GET "${report}" region_mm 1)
string(JSON side GET "${report}" region_mm 2)
# CMake counts in whole numbers: thousandths of a millimetre.
foreach(name IN ITEMS x y side)
  string(REGEX MATCH "^(-?)([0-9]*)\\.?([0-9]*)" found "${${name}}")
  set(sign "${CMAKE_MATCH_1}")
  string(SUBSTRING "${CMAKE_MATCH_3}000" 0 3 thousandths)
  math(EXPR ${name} "${sign}(${CMAKE_MATCH_2} * 1000 + 1${thousandths} - 1000)")
endforeach()
function(millimetres value result)
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
math(EXPR x0 "${x} + ${side} * 45 / 100")
math(EXPR x1 "${x} + ${side} * 55 / 100")
math(EXPR ym "${y} + ${side} / 2")
millimetres(${x0} x0)
millimetres(${x1} x1)
millimetres(${ym} ym)
# Heights where the stroke begins and ends.
execute_process(COMMAND ${RELIEVO} measure ${MAP} --point ${x0},${ym} --point ${x1},${ym}
  --report json OUTPUT_VARIABLE report COMMAND_ERROR_IS_FATAL ANY)
string(JSON z0 GET "${report}" measurements 0 quantities 0 value)
string(JSON z1 GET "${report}" measurements 1 quantities 0 value)
foreach(name IN ITEMS z0 z1)
  string(REGEX MATCH "^(-?)([0-9]*)\\.?([0-9]*)" found "${${name}}")
  set(sign "${CMAKE_MATCH_1}")
  string(SUBSTRING "${CMAKE_MATCH_3}000" 0 3 thousandths)
  math(EXPR ${name} "${sign}(${CMAKE_MATCH_2} * 1000 + 1${thousandths} - 1000)")
endforeach()
# Above by 4 % of the side, pressed in by 2 %.
math(EXPR up "${z0} + ${side} * 4 / 100")
math(EXPR in0 "${z0} - ${side} * 2 / 100")
math(EXPR in1 "${z1} - ${side} * 2 / 100")
millimetres(${up} up)
millimetres(${in0} in0)
millimetres(${in1} in1)
file(WRITE ${OUT}/stroke.csv "t_s,x_mm,y_mm,z_mm\n0,${x0},${ym},${up}\n1,${x0},${ym},${in0}\n"
  "3,${x1},${ym},${in1}\n4,${x1},${ym},${in1}\n")
execute_process(COMMAND ${RELIEVO} touch ${MAP} --stroke ${OUT}/stroke.csv -o ${OUT}/force.csv
  --plot ${OUT}/force.svg COMMAND_ERROR_IS_FATAL ANY)
