# Headers of Windows of which nothing is used. The adapter has the Windows.h that the code needs.
s/#include (<tchar\.h>|<windows\.h>|"Shlwapi\.h"|<conio\.h>)//
# Paths as other systems than Windows write them.
s/ICH\\/ICH\//g
s/DGG_definition/dgg_definition/g
# The graph can be filled without a file.
s/private:/public:/
# Members of a base class that depends on a template's argument must be named as such.
s/(^|[^>A-Za-z0-9_])(node_number_\b|graph_neighbor(_dis)?\[)/\1this->\2/g
s/int this->/int /g
# A function of Visual Studio.
s/\b_finite\b/std::isfinite/g
# A temporary object cannot be bound to a reference that is not constant.
s/CPoint3D& normal = /CPoint3D normal = /
s/\.swap\(vector<\w+>\(\w+\)\)/.shrink_to_fit()/g
s/QuoteInfoAtVertex& quoteOfPseudoSource/const &/g
