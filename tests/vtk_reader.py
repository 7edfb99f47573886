"""Reads a VTK PolyData file with VTK's own reader and prints what it found as JSON. Exit code 77: no VTK for Python."""
import json
import sys

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    print("VTK for Python is not installed (Debian: python3-vtk9)")
    sys.exit(77)


def arrays(attributes):
    found = {}
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(i)
        found[array.GetName()] = [array.GetTuple(k) for k in range(array.GetNumberOfTuples())]
    return found


reader = vtkXMLPolyDataReader()
reader.SetFileName(sys.argv[1])
reader.Update()
if reader.GetErrorCode() != 0:
    sys.exit("VTK reports error %d" % reader.GetErrorCode())
data = reader.GetOutput()
print(
    json.dumps(
        {
            "points": [data.GetPoint(i) for i in range(data.GetNumberOfPoints())],
            "verts": data.GetNumberOfVerts(),
            "lines": data.GetNumberOfLines(),
            "polys": data.GetNumberOfPolys(),
            "cell_sizes": [data.GetCell(i).GetNumberOfPoints() for i in range(data.GetNumberOfCells())],
            "point_data": arrays(data.GetPointData()),
            "cell_data": arrays(data.GetCellData()),
        }
    )
)
